-- Version 1. Units stand in the column names; *_si columns are in the unit their unit_si column names.
-- A REAL column cannot hold NaN or -0.0: where a double is one of these, the *_bits column beside it holds its 64 bits.

CREATE TABLE counter (name TEXT PRIMARY KEY, value INTEGER NOT NULL) STRICT, WITHOUT ROWID;

CREATE TABLE experiment (
  id INTEGER PRIMARY KEY,
  label TEXT NOT NULL UNIQUE,          -- what people type
  name TEXT NOT NULL,                  -- from the design
  request_id TEXT NOT NULL UNIQUE,
  digest TEXT NOT NULL UNIQUE,         -- of the resolved design: equal digest, same experiment
  design_yaml TEXT NOT NULL,
  file_name TEXT NOT NULL,
  array TEXT NOT NULL,                 -- 'L32', 'table', ...
  summary TEXT NOT NULL,               -- JSON, as shown when submitted
  state TEXT NOT NULL CHECK (state IN ('running', 'done', 'failed', 'cancelled')),
  created_ms INTEGER NOT NULL,         -- Unix time
  ended_ms INTEGER
) STRICT;
CREATE TABLE design_file (
  experiment INTEGER NOT NULL REFERENCES experiment, name TEXT NOT NULL, bytes BLOB NOT NULL, PRIMARY KEY (experiment, name)
) STRICT, WITHOUT ROWID;
CREATE TABLE factor (
  experiment INTEGER NOT NULL REFERENCES experiment, n INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL,
  PRIMARY KEY (experiment, n)
) STRICT, WITHOUT ROWID;
CREATE TABLE level (
  experiment INTEGER NOT NULL, factor INTEGER NOT NULL, n INTEGER NOT NULL, label TEXT NOT NULL,
  PRIMARY KEY (experiment, factor, n), FOREIGN KEY (experiment, factor) REFERENCES factor
) STRICT, WITHOUT ROWID;
CREATE TABLE point_level (
  experiment INTEGER NOT NULL, point INTEGER NOT NULL, factor INTEGER NOT NULL, level INTEGER NOT NULL,
  PRIMARY KEY (experiment, point, factor), FOREIGN KEY (experiment, factor, level) REFERENCES level
) STRICT, WITHOUT ROWID;
CREATE TABLE response (               -- what the study was asked to measure
  experiment INTEGER NOT NULL REFERENCES experiment, n INTEGER NOT NULL, id TEXT NOT NULL, unit_si TEXT NOT NULL,
  stage TEXT NOT NULL, PRIMARY KEY (experiment, n)
) STRICT, WITHOUT ROWID;

CREATE TABLE job (
  id INTEGER PRIMARY KEY,
  stage_key TEXT NOT NULL UNIQUE,      -- SHA-256 of the canonical text: equal key, equal bits
  stage TEXT NOT NULL CHECK (stage IN ('settle', 'fabric', 'repose', 'stress')),
  parent INTEGER REFERENCES job,       -- the settle stage
  seed INTEGER NOT NULL,
  confining_stress_pa REAL NOT NULL,
  friction_angle_rad REAL NOT NULL,
  normal_stiffness_n_per_m REAL NOT NULL,
  normal_damping REAL NOT NULL,        -- N s/m, or a ratio when damping_is_ratio
  tangential_stiffness_n_per_m REAL NOT NULL,
  tangential_damping REAL NOT NULL,
  largest_diameter_m REAL NOT NULL,
  particle_kind INTEGER NOT NULL,      -- spheres per cluster, 12 = mixture
  rotation INTEGER NOT NULL,           -- 0 none, 1 x, 2 z, 3 xz
  damping_is_ratio INTEGER NOT NULL,
  grain_density_kg_per_m3 REAL NOT NULL,
  gravity_m_per_s2 REAL NOT NULL,
  clusters INTEGER NOT NULL,
  box_length_m REAL NOT NULL,          -- 0 = by rule
  box_width_m REAL NOT NULL,
  settle_stiffness_number REAL NOT NULL,
  stress_stiffness_number REAL NOT NULL,
  mass_floor REAL NOT NULL,
  step_fraction REAL NOT NULL,
  inertial_number REAL NOT NULL,
  axial_strain REAL NOT NULL,
  state TEXT NOT NULL CHECK (state IN ('blocked', 'ready', 'leased', 'backoff', 'succeeded', 'failed', 'skipped', 'cancelled',
                                       'quarantined')),
  lease_token INTEGER NOT NULL,
  worker TEXT NOT NULL,
  attempts INTEGER NOT NULL,
  deaths INTEGER NOT NULL,
  deaths_anywhere INTEGER NOT NULL,
  death_steps INTEGER NOT NULL,
  detail TEXT NOT NULL,
  bed TEXT REFERENCES artifact,
  checkpoint TEXT REFERENCES artifact
) STRICT;
CREATE INDEX job_bed ON job (bed) WHERE bed IS NOT NULL;
CREATE INDEX job_checkpoint ON job (checkpoint) WHERE checkpoint IS NOT NULL;

CREATE TABLE experiment_job (         -- where a job stands: beds are shared, so many to many
  experiment INTEGER NOT NULL REFERENCES experiment, n INTEGER NOT NULL, job INTEGER NOT NULL REFERENCES job,
  point INTEGER NOT NULL, seed INTEGER NOT NULL, reused INTEGER NOT NULL, PRIMARY KEY (experiment, n)
) STRICT, WITHOUT ROWID;
CREATE INDEX experiment_job_job ON experiment_job (job);

CREATE TABLE attempt (
  lease_token INTEGER PRIMARY KEY, job INTEGER NOT NULL REFERENCES job, worker TEXT NOT NULL,
  started_ms INTEGER NOT NULL, ended_ms INTEGER, outcome TEXT, detail TEXT
) STRICT;
CREATE INDEX attempt_job ON attempt (job);

CREATE TABLE result (
  job INTEGER PRIMARY KEY REFERENCES job, lease_token INTEGER NOT NULL UNIQUE, stage_end INTEGER NOT NULL,
  stage_end_name TEXT NOT NULL, reason TEXT NOT NULL, wall_s REAL NOT NULL, steps INTEGER NOT NULL,
  committed_ms INTEGER NOT NULL
) STRICT;
CREATE TABLE measurement (
  job INTEGER NOT NULL REFERENCES result ON DELETE CASCADE, role TEXT NOT NULL CHECK (role IN ('response', 'numerics')),
  n INTEGER NOT NULL, id TEXT NOT NULL, value_si REAL, value_bits INTEGER, unit_si TEXT NOT NULL,
  standard_error_si REAL, standard_error_bits INTEGER, definition TEXT NOT NULL, PRIMARY KEY (job, role, n)
) STRICT, WITHOUT ROWID;
CREATE TABLE curve (
  job INTEGER NOT NULL REFERENCES result ON DELETE CASCADE, n INTEGER NOT NULL, id TEXT NOT NULL, test TEXT NOT NULL,
  x_name TEXT NOT NULL, x_unit_si TEXT NOT NULL, y_name TEXT NOT NULL, y_unit_si TEXT NOT NULL, PRIMARY KEY (job, n)
) STRICT, WITHOUT ROWID;
CREATE TABLE curve_point (            -- a missing x or y: the arrays differ in length
  job INTEGER NOT NULL, curve INTEGER NOT NULL, n INTEGER NOT NULL, x_si REAL, x_bits INTEGER, y_si REAL, y_bits INTEGER,
  PRIMARY KEY (job, curve, n), FOREIGN KEY (job, curve) REFERENCES curve ON DELETE CASCADE
) STRICT, WITHOUT ROWID;

CREATE TABLE artifact (               -- a file DB.d/cas/<first two digits>/<other 62>, named by its SHA-256
  digest TEXT PRIMARY KEY, bytes INTEGER NOT NULL, created_ms INTEGER NOT NULL
) STRICT, WITHOUT ROWID;
CREATE TABLE event (
  experiment INTEGER NOT NULL REFERENCES experiment, seq INTEGER NOT NULL, unix_ms INTEGER NOT NULL, text TEXT NOT NULL,
  PRIMARY KEY (experiment, seq)
) STRICT, WITHOUT ROWID;

-- For pandas and R: pandas.read_sql("SELECT * FROM responses_wide WHERE experiment = 'article-l32-...'", connection)

CREATE VIEW stages AS
SELECT e.label AS experiment, ej.point, ej.seed, j.stage, CASE j.stage WHEN 'stress' THEN j.confining_stress_pa END AS sigma3_pa,
       j.state, r.stage_end_name AS stage_end, coalesce(r.reason, j.detail) AS reason, r.wall_s, r.steps, ej.reused, j.id AS job,
       j.stage_key
FROM experiment_job ej JOIN experiment e ON e.id = ej.experiment JOIN job j ON j.id = ej.job LEFT JOIN result r ON r.job = j.id;

CREATE VIEW measurements AS
SELECT s.experiment, s.point, s.seed, s.stage, s.sigma3_pa, m.role, m.id, m.value_si, m.standard_error_si, m.unit_si, m.definition
FROM stages s JOIN measurement m ON m.job = s.job;

CREATE VIEW responses_wide AS
SELECT experiment, point, seed,
       max(value_si) FILTER (WHERE id = 'contacts_per_particle') AS contacts_per_particle,
       max(value_si) FILTER (WHERE id = 'bulk_density') AS bulk_density_kg_per_m3,
       max(value_si) FILTER (WHERE id = 'void_ratio') AS void_ratio,
       max(value_si) FILTER (WHERE id = 'repose_angle') AS repose_angle_rad
FROM measurements WHERE role = 'response' GROUP BY experiment, point, seed;

CREATE VIEW strength AS
SELECT experiment, point, seed, sigma3_pa, value_si AS sigma1_pa, standard_error_si AS sigma1_standard_error_pa
FROM measurements WHERE role = 'response' AND stage = 'stress' AND id GLOB 'sigma1_at_sigma3_*';

CREATE VIEW curves AS
SELECT s.experiment, s.point, s.seed, s.stage, s.sigma3_pa, c.id, c.test, c.x_name, c.x_unit_si, c.y_name, c.y_unit_si, p.n, p.x_si,
       p.y_si
FROM stages s JOIN curve c ON c.job = s.job JOIN curve_point p ON p.job = c.job AND p.curve = c.n;

CREATE VIEW factors AS
SELECT e.label AS experiment, pl.point, f.name AS factor, f.unit, l.label AS level
FROM point_level pl JOIN experiment e ON e.id = pl.experiment JOIN factor f ON f.experiment = pl.experiment AND f.n = pl.factor
JOIN level l ON l.experiment = pl.experiment AND l.factor = pl.factor AND l.n = pl.level;
