//! Which variable stands for which: names, types, physical units.

use std::fs;

use super::{Bench, Description};
use crate::common::run;

#[test]
fn units_are_compared_by_their_base_units_and_values_converted() {
    let bench = Bench::new();
    let millimetres = r#"<UnitDefinitions><Unit name="mm"><BaseUnit m="1" factor="0.001"/></Unit></UnitDefinitions>"#;
    let types_2 = r#"<TypeDefinitions><SimpleType name="Length"><Real unit="mm"/></SimpleType></TypeDefinitions>"#;
    let types_3 = r#"<TypeDefinitions><Float64Type name="Length" unit="mm"/></TypeDefinitions>"#;
    let mut flown_units = 0;
    for (version, types) in [("2.0", types_2), ("3.0", types_3)] {
        let library = bench.library("NONE", version, &[]);
        for unit in [r#"unit="mm""#, r#"declaredType="Length""#] {
            let mut description = Description::of(version).with("x", unit).with("x0", unit);
            description.head = format!("{millimetres}{types}");
            bench.fmu("plant.fmu", &description, &library);
            let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
            assert_eq!(flown.code, 0, "{}", flown.err);
            // 20 m are 20,000 mm; 40 steps of 0.05 are 2 mm more.
            assert_eq!(flown.rows[1][8], "20.0");
            assert!((flown.last() - 20.002).abs() < 1e-9, "{}", flown.last());
            assert!(flown.err.contains("`x` is in `mm`: converted to `m`"), "{}", flown.err);
            flown_units += 1;
        }
        let same = Description::of(version).with("vx", r#"unit="m.s-1""#);
        bench.fmu("plant.fmu", &same, &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!((flown.code, flown.err.as_str()), (0, ""));
        let other = Description::of(version).with("vx", r#"unit="m.s-2""#);
        bench.fmu("plant.fmu", &other, &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains("`vx` is in `m.s-2`: expected `m/s`"), "{}", flown.err);
    }
    assert_eq!(flown_units, 4);
}

/// Units with an offset, as degrees Celsius have it: marks are half a metre long and begin at 100 m.
#[test]
fn values_in_units_with_an_offset_are_converted_both_ways() {
    let bench = Bench::new();
    let unit = r#"unit="mark""#;
    for version in ["2.0", "3.0"] {
        let library = bench.library("NONE", version, &[]);
        let mut description = Description::of(version).with("x", unit).with("x0", unit);
        description.head = r#"<UnitDefinitions><Unit name="mark"><BaseUnit m="1" factor="0.5" offset="100"/></Unit></UnitDefinitions>"#.to_owned();
        bench.fmu("plant.fmu", &description, &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!(flown.code, 0, "{}", flown.err);
        assert!(bench.trace().contains(&"parameter early -160".to_owned()), "20 m is mark -160");
        // 40 steps of 0.05 are 2 marks more.
        assert_eq!(flown.rows[1][8], "20.0");
        assert!((flown.last() - 21.0).abs() < 1e-9, "{}", flown.last());
        assert!(flown.err.contains("`x` is in `mark`: converted to `m`"), "{}", flown.err);
        // A unit that measures something else is none the better for its offset.
        description.head = description.head.replace("m=\"1\"", "K=\"1\"");
        bench.fmu("plant.fmu", &description, &library);
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
        assert_eq!(flown.code, 2);
        assert!(flown.err.contains("is in `mark`: expected `m`"), "{}", flown.err);
    }
}

#[test]
fn variables_that_do_not_fit_are_refused_before_the_run() {
    let bench = Bench::new();
    let refused = |names: &str, part: &str| {
        let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], names), &[]);
        assert_eq!((flown.code, flown.out.as_str()), (2, ""), "{part}: {}", flown.err);
        assert!(flown.err.contains(part), "{}", flown.err);
    };
    let library = bench.library("NONE", "3.0", &[]);
    bench.fmu("plant.fmu", &Description::of("3.0"), &library);
    refused("[unit.names]\ny = \"x\"", "variable `y`: `");
    refused("[unit.names]\ny = \"x\"", "`x` stands for `x` already: expected one for each");
    let mut integer = Description::of("3.0");
    integer.more =
        r#"<Int32 name="arm" valueReference="200" causality="parameter" start="1"/>"#.into();
    bench.fmu("plant.fmu", &integer, &library);
    refused("", "variable `arm`: `");
    refused("", "`arm` has type Int32: expected Real or Float64 or Float32");
    let mut array = Description::of("3.0");
    array.more = r#"<Float64 name="arm" valueReference="200" causality="parameter" start="1 2 3"><Dimension start="3"/></Float64>"#.into();
    bench.fmu("plant.fmu", &array, &library);
    refused("", "`arm` is an array: expected a single value");
    let mut local = Description::of("3.0");
    local.more = r#"<Float64 name="arm" valueReference="200" causality="local"/>"#.into();
    bench.fmu("plant.fmu", &local, &library);
    let flown = bench.fly_scenario(&bench.scenario(&[(2, "plant.fmu")], ""), &[]);
    assert_eq!(flown.code, 0, "{}", flown.err);
    assert!(flown.err.contains("`arm` is local, no parameter: it is not set"), "{}", flown.err);
}

/// A project as the INTO-CPS application lays it out, with a plant of another tool whose variables
/// have other names: the connections tell which are which.
#[test]
fn a_multi_model_with_a_foreign_plant_its_configuration_and_uris_flies() {
    crate::common::fmu_binary();
    let bench = Bench::new();
    let project = bench.path("my project");
    let (exported, models) = (bench.path("exported"), project.join("Multi-models/mm"));
    fs::create_dir_all(models.join("co-sim")).unwrap();
    fs::create_dir_all(project.join("FMUs")).unwrap();
    let export = ["export", "into-cps", "scenarios/paper.toml", "--duration", "2", "--out"];
    let args = [&export[..], &[exported.to_str().unwrap()]].concat();
    assert_eq!(run(&args).0, 0);
    let text = fs::read_to_string(exported.join("multi-model.json")).unwrap();
    let mut model: serde_json::Value = serde_json::from_str(&text).unwrap();
    for (index, file) in ["coordination_double", "control", "plant"].iter().enumerate() {
        let name = format!("cordon_{file}.fmu");
        fs::rename(exported.join(&name), project.join("FMUs").join(&name)).unwrap();
        // By its name, by URIs with three and four slashes.
        let path = project.join("FMUs").join(&name).display().to_string().replace(' ', "%20");
        let uri = [name, format!("file://{path}"), format!("file:///{path}")][index].clone();
        model["fmus"][format!("{{cordon_{file}}}")] = uri.into();
    }
    // Drone 2 gets the other plant.
    let mut description = Description::of("2.0");
    let renamed = |d: &Description| {
        d.text().replace("name=\"x\"", "name=\"pos.x\"").replace("name=\"w1\"", "name=\"front\"")
    };
    description.head.clear();
    let library = bench.library("EARLY_ONLY", "2.0", &[]);
    let xml = renamed(&description);
    let files: [(&str, &[u8]); 2] =
        [("modelDescription.xml", xml.as_bytes()), ("binaries/linux64/plant.so", &library)];
    bench.archive("my project/FMUs/other.fmu", &files);
    let text = serde_json::to_string(&model).unwrap();
    let text = text
        .replace("{cordon_plant}.plant2.x\"", "{other}.plant2.pos.x\"")
        .replace("{cordon_plant}.plant2.w1\"", "{other}.plant2.front\"")
        .replace("{cordon_plant}.plant2", "{other}.plant2");
    let mut model: serde_json::Value = serde_json::from_str(&text).unwrap();
    model["fmus"]["{other}"] = "other.fmu".into();
    model["parameters"]["{other}.plant2.x0"] = 17.5.into();
    let mut configuration = serde_json::json!({ "multimodel_path": "Multi-models/mm/mm.json" });
    for key in ["algorithm", "endTime", "startTime"] {
        configuration[key] = model[key].take();
        model.as_object_mut().unwrap().remove(key);
    }
    fs::write(models.join("mm.json"), model.to_string()).unwrap();
    let coe = models.join("co-sim/co-sim.coe.json");
    fs::write(&coe, configuration.to_string()).unwrap();
    let flown = bench.fly_scenario(coe.to_str().unwrap(), &[]);
    assert_eq!(flown.code, 0, "{}", flown.err);
    assert_eq!(flown.rows.len(), 42);
    assert_eq!(flown.rows[1][8], "17.5");
    assert!((flown.last() - 19.5).abs() < 1e-9, "{}", flown.last());
    assert!(flown.out.contains("plant2 is `other.fmu`"), "{}", flown.out);
    // The multi-model alone does not say how it is stepped.
    let mm = models.join("mm.json");
    let flown = bench.fly_scenario(mm.to_str().unwrap(), &[]);
    assert_eq!(flown.code, 2);
    assert!(flown.err.contains("algorithm is missing"), "{}", flown.err);
    model["fmus"]["{other}"] = "file:///no%20such.fmu".into();
    fs::write(&mm, model.to_string()).unwrap();
    let flown = bench.fly_scenario(coe.to_str().unwrap(), &[]);
    assert_eq!(flown.code, 74);
    assert!(flown.err.contains("cannot read `/no such.fmu`"), "{}", flown.err);
}
