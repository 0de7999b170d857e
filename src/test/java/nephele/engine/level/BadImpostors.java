package nephele.engine.level;

import static nephele.engine.level.BadLevel.level;

import java.util.List;

/** Models over fields that cannot be planted. */
final class BadImpostors {
    private static final String GROUND =
            "\"solids\": [{\"id\": \"g\", \"kind\": \"box\", \"centre\": [0, -1, 0], \"size\": [10, 2, 10]}], ";
    private static final String IMPOSTOR = "\"impostor\": true, ";

    static final List<BadLevel> ALL = List.of(
            models("[0].impostor", "must be true or false", one("a", "\"impostor\": 1, " + field(1, ""))),
            models("[0].field", "add \"impostor\": true", one("a", field(1, ""))),
            models(
                    "[0].parent",
                    "leave out the parent",
                    one("a", IMPOSTOR + "\"parent\": \"b\", " + field(1, "")) + ", " + one("b", IMPOSTOR)),
            models(
                    "[1].parent",
                    "planted at many places",
                    one("a", IMPOSTOR + field(1, "")) + ", " + one("b", "\"parent\": \"a\", ")),
            models("[0].portalable", "not solid", one("a", IMPOSTOR + "\"portalable\": true, " + field(1, ""))),
            models("[0].heightVariation", "must be from 0 to 0.9", one("a", IMPOSTOR + "\"heightVariation\": 1, ")),
            models(
                    "[0].field.terrain",
                    "there is no terrain 'hills'",
                    one("a", IMPOSTOR + field(1, ", \"terrain\": \"hills\""))),
            models(
                    "[0].field.heightRangeMetres",
                    "the lowest height comes first",
                    one("a", IMPOSTOR + field(1, ", \"heightRangeMetres\": [2, 1]"))),
            models("[0].field.count", "fit at spacingMetres 1", one("a", IMPOSTOR + field(1000, ""))),
            models(
                    "[0].field.densityMap",
                    "there is no such file",
                    one("a", IMPOSTOR + field(1, ", \"densityMap\": \"none.png\""))),
            level(
                    "models[0].field",
                    "add a terrain, a solid or a model",
                    "\"models\": [" + one("a", IMPOSTOR + field(1, "")) + "]"),
            models(
                    "[1]",
                    "at most 200000 impostors",
                    one("a", IMPOSTOR + field(200_000, "")) + ", " + one("b", IMPOSTOR)));

    private BadImpostors() {}

    private static String field(int count, String more) {
        return "\"field\": {\"count\": " + count + ", \"spacingMetres\": 1" + more + "}, ";
    }

    private static String one(String id, String members) {
        return "{\"id\": \"" + id + "\", " + members + "\"file\": \"box_1_1.3d\"}";
    }

    private static BadLevel models(String path, String words, String models) {
        return level("models" + path, words, GROUND + "\"models\": [" + models + "]");
    }
}
