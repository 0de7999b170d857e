package nephele.engine.level;

import static nephele.engine.level.BadLevel.level;

import java.util.List;
import nephele.engine.level.json.JsonTree;

/** Numbers and values of single keys that no level may hold. */
final class BadValues {
    static final List<BadLevel> ALL = List.of(
            stops("NaN", "not valid JSON"),
            stops("Infinity", "not valid JSON"),
            stops("-Infinity", "not valid JSON"),
            stops("1e999", "too large"),
            stops("-1e400", "too large"),
            stops("1e39", "must be from -32 to 32"),
            stops("1e1000000000", "too large"),
            stops("9".repeat(10_000), "not valid JSON"),
            stops("\"1.5\"", "a number or \"auto\""),
            stops("\"automatic\"", "must be a number or \"auto\", not 'automatic'"),
            stops("\"Auto\"", "must be a number or \"auto\""),
            stops("null", "leave the key out or give a number or \"auto\""),
            stops("[0]", "a number or \"auto\""),
            stops("-32.001", "must be from -32 to 32"),
            stops("1,5", "not valid JSON"),
            stops("+1", "not valid JSON"),
            stops(".5", "not valid JSON"),
            stops("5.", "not valid JSON"),
            stops("01", "not valid JSON"),
            stops("0x10", "not valid JSON"),
            stops("١", "not valid JSON"),
            stops("null", "null is not allowed"),
            stops("true", "a number"),
            stops("[1]", "a number"),
            stops("{}", "a number"),
            prism("sides", "3.5", "whole number"),
            prism("sides", "1e10", "must be from"),
            prism("sides", "-4", "must be from"),
            prism("sides", "2", "must be from"),
            prism("sides", "63", "must be from"),
            prism("radiusMetres", "0", "must be from"),
            prism("heightMetres", "-1", "must be from"),
            box("centre", "[0, 0]", "three numbers"),
            box("centre", "[0, 0, 0, 0]", "three numbers"),
            box("centre", "0", "an array of three numbers"),
            box("centre", "{\"x\": 0}", "an array of three numbers"),
            box("centre[1]", "[0, 1e30, 0]", "must be from"),
            box("centre[2]", "[0, 0, null]", "null is not allowed"),
            box("size[0]", "[0, 1, 1]", "must be from"),
            box("size[1]", "[1, -1, 1]", "must be from"),
            box("size[2]", "[1, 1, 1e-30]", "must be from"),
            box("portalable", "1", "true or false"),
            box("portalable", "\"true\"", "true or false"),
            box("material", "5", "a text"),
            box("textureMapping", "\"WORLD\"", "must be one of"),
            box("faces", "[]", "an object"),
            box("faces.up", "{\"up\": {}}", "unknown key"),
            box("faces.+y.colour", "{\"+y\": {\"colour\": 1}}", "unknown key"),
            texture("scaleU", "NaN", "not valid JSON"),
            texture("scaleU", "20000", "must be from"),
            texture("scaleU", "0", "from 0.001 to 10000, not 0"),
            texture("scaleV", "-0.0009", "from -10000 to -0.001 or"),
            texture("scaleV", "\"1\"", "a number"),
            texture("scale", "2", "unknown key"),
            texture("rotationDegrees", "361", "must be from -360 to 360"),
            texture("shiftUMetres", "1e8", "must be from"),
            texture("shiftVMetres", "1e999", "too large"),
            box("faces.+y.texture", "{\"+y\": {\"texture\": 1}}", "an object"),
            emitter(
                    "kind",
                    "\"kind\": \"steam\", \"size\": [1, 1, 1], \"ratePerSecond\": 1",
                    "must be one of [fire, smoke"),
            emitter("kind", "\"size\": [1, 1, 1], \"ratePerSecond\": 1", "is missing"),
            emitter(
                    "ratePerSecond",
                    "\"kind\": \"fire\", \"size\": [1, 1, 1], \"ratePerSecond\": -1",
                    "must be 0 or from 0.000001 to 1000000"),
            emitter(
                    "size[1]",
                    "\"kind\": \"fire\", \"size\": [1, 0, 1], \"ratePerSecond\": 1",
                    "must be from 0.01 to 1000"),
            emitter(
                    "seed",
                    "\"kind\": \"fire\", \"size\": [1, 1, 1], \"ratePerSecond\": 1, \"seed\": 0.5",
                    "whole number"),
            level(
                    "environment.lightning.strikesPerMinute",
                    "must be 0 or from 0.001 to 30",
                    "\"environment\": {\"lightning\": {\"strikesPerMinute\": 31, \"centre\": [0, 900, 0], \"size\":"
                            + " [9, 9, 9]}}"),
            level("solids[0].kind", "is missing", "\"solids\": [{\"id\": \"a\"}]"),
            level("solids[0].kind", "no kind", "\"solids\": [{\"id\": \"a\", \"kind\": \"sphere\"}]"),
            level("solids[0].kind", "no kind", "\"solids\": [{\"id\": \"a\", \"kind\": 1}]"),
            level("solids[0]", "an object", "\"solids\": [[]]"),
            level("solids", "an array", "\"solids\": {}"),
            level("materials[0].id", "is missing", "\"materials\": [{}]"),
            level("materials[0].id", "characters is wanted", "\"materials\": [{\"id\": \"\"}]"),
            id("\\n", "U+000A"),
            id("\\u202e", "U+202E"),
            id("\\u2066", "U+2066"),
            id("\\u200b", "U+200B"),
            id("\\ufeff", "U+FEFF"),
            id("\\u2028", "U+2028"),
            level("materials[0].id", "can be seen", "\"materials\": [{\"id\": \"  \"}]"),
            level("materials[0].id", "can be seen", "\"materials\": [{\"id\": \"\\u00a0\\u3000\\u3164\"}]"),
            level("materials[0].id", "can be seen", "\"materials\": [{\"id\": \"\\u2800\"}]"),
            level("materials[0].roughness", "must be from", "\"materials\": [{\"id\": \"m\", \"roughness\": -1}]"),
            level(
                    "materials[0].textureMetres",
                    "must be from",
                    "\"materials\": [{\"id\": \"m\", \"textureMetres\": 0}]"),
            level(
                    "materials[0].baseColour[0]",
                    "must be from",
                    "\"materials\": [{\"id\": \"m\", \"baseColour\": [2, 0, 0]}]"),
            level(
                    "environment.sky.radiance[0]",
                    "must be from",
                    "\"environment\": {\"sky\": {\"kind\": \"constant\", \"radiance\": [-1, 0, 0]}}"),
            level(
                    "environment.sky.files",
                    "at most 6",
                    "\"environment\": {\"sky\": {\"kind\": \"skybox\", \"files\": [1,1,1,1,1,1,1]}}"),
            level(
                    "environment.clouds[0].density.seed",
                    "to 9007199254740991, not 9007199254740993",
                    cloud("{\"kind\": \"noise\", \"seed\": 9007199254740993}")),
            level("environment.clouds[0].density.kind", "no kind", cloud("{\"kind\": \"fluff\"}")),
            level(
                    "environment.clouds[0].density.erosion",
                    "must be from",
                    cloud("{\"kind\": \"noise\", \"erosion\": 2}")),
            level(
                    "environment.clouds[0].density.profile",
                    "one of",
                    cloud("{\"kind\": \"noise\", \"profile\": \"fog\"}")),
            level(
                    "environment.clouds[0].density.anvil",
                    "unknown key",
                    cloud("{\"kind\": \"ellipsoid\", \"anvil\": 1}")),
            level(
                    "environment.clouds[0].density.fill.count",
                    "must be from",
                    cloud("{\"kind\": \"puffs\", \"fill\": {\"boxes\": [], \"count\": 1000000}}")),
            level(
                    "environment.clouds[0].density.fill.boxes",
                    "is missing",
                    cloud("{\"kind\": \"puffs\", \"fill\": {}}")),
            level(
                    "environment.weatherSeed",
                    "to 9007199254740991, not -9007199254740995",
                    "\"environment\": {\"weather\": \"few\", \"weatherSeed\": -9007199254740995}"),
            level(
                    "environment.clouds[0].evolutionSeconds",
                    "must be 0 or from 1 to",
                    cloud("{\"kind\": \"noise\"}").replace("}}]", "}, \"evolutionSeconds\": 0.5}]")),
            level(
                    "environment.sky.dayLengthSeconds",
                    "must be 0 or from 1 to",
                    "\"environment\": {\"sky\": {\"kind\": \"atmosphere\", \"dayLengthSeconds\": 5e-324}}"),
            level("environment.weather", "one of", "\"environment\": {\"weather\": \"rain\"}"),
            level(
                    "environment.clouds[0].size",
                    "unknown key",
                    "\"environment\": {\"clouds\": [{\"id\": \"c\", \"kind\": \"layer\", \"baseAltitudeMetres\": 1,"
                            + " \"thicknessMetres\": 1, \"size\": [1, 1, 1]}]}"),
            camera("horizontalFovDegrees", "0", "must be from 1 to 170"),
            camera("horizontalFovDegrees", "180", "must be from 1 to 170"),
            camera("nearMetres", "0", "must be from"),
            camera("path", "[1]", "an object"));

    private BadValues() {}

    /** Returns a document with an id that contains an escaped character. */
    private static BadLevel id(String escaped, String words) {
        BadLevel bad = level("materials[0].id", words, "\"materials\": [{\"id\": \"a" + escaped + "b\"}]");
        return new BadLevel("id with " + words, bad.path(), words, bad.content());
    }

    private static BadLevel emitter(String path, String members, String words) {
        return level(
                "emitters[0]." + path,
                words,
                "\"emitters\": [{\"id\": \"e\", \"centre\": [0, 0, 0], " + members + "}]");
    }

    private static BadLevel stops(String value, String words) {
        return new BadLevel("number " + JsonTree.shortened(value), "environment", words, () -> BadLevel.wrap(
                        "\"environment\": {\"exposureStops\": " + value + "}")
                .getBytes(java.nio.charset.StandardCharsets.UTF_8));
    }

    private static BadLevel prism(String key, String value, String words) {
        String rest = key.equals("sides")
                ? "\"radiusMetres\": 1, \"heightMetres\": 1"
                : key.equals("radiusMetres") ? "\"heightMetres\": 1" : "\"radiusMetres\": 1";
        return level(
                "solids[0]." + key,
                words,
                "\"solids\": [{\"id\": \"p\", \"kind\": \"prism\", \"centre\": [0, 0, 0], " + rest + ", \"" + key
                        + "\": " + value + "}]");
    }

    /** @param path the key, optionally with a place inside its value */
    private static BadLevel box(String path, String value, String words) {
        String key = path.replaceFirst("[.\\[].*", "");
        String centre = key.equals("centre") ? "" : "\"centre\": [0, 0, 0], ";
        String size = key.equals("size") ? "" : "\"size\": [1, 1, 1], ";
        return level(
                "solids[0]." + path,
                words,
                "\"solids\": [{\"id\": \"b\", \"kind\": \"box\", " + centre + size + "\"" + key + "\": " + value
                        + "}]");
    }

    private static BadLevel texture(String key, String value, String words) {
        return box("faces.+y.texture." + key, "{\"+y\": {\"texture\": {\"" + key + "\": " + value + "}}}", words);
    }

    private static BadLevel camera(String key, String value, String words) {
        return level(
                "cameras[0]." + key,
                words,
                "\"cameras\": [{\"id\": \"c\", \"position\": [0, 0, 0], \"target\": [0, 0, 1], \"" + key + "\": "
                        + value + "}]");
    }

    private static String cloud(String density) {
        return "\"environment\": {\"clouds\": [{\"id\": \"c\", \"kind\": \"volume\", \"centre\": [0, 0, 0],"
                + " \"size\": [1, 1, 1], \"density\": " + density + "}]}";
    }
}
