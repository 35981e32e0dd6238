# cmake -DSOURCES=a;b -DOUT=method.cpp -P method.cmake: the digest of the sources that a diagnosis is computed by.
set(ALL "")
foreach(source ${SOURCES})
  file(SHA256 ${source} digest)
  get_filename_component(name ${source} NAME)
  string(APPEND ALL "${name} ${digest}\n")
endforeach()
string(SHA256 METHOD "${ALL}")
file(WRITE ${OUT} "#include \"scheduler/gap/method.h\"\n\nnamespace regolab::gap {\nstd::string_view method_digest() { return \"${METHOD}\"; }\n}  // namespace regolab::gap\n")
