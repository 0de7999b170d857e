package nephele.engine.level;

import static nephele.engine.level.BadLevel.level;

import java.util.List;

/** Billboards that stand nowhere, have no room, or whose pictures do not hold what they say. */
final class BadBillboards {
    private static final String GROUND =
            "\"solids\": [{\"id\": \"g\", \"kind\": \"box\", \"centre\": [0, -1, 0], \"size\": [10, 2, 10]}], ";
    private static final String SIZE = "\"sizeMetres\": [1, 2]";
    private static final String HERE = "\"at\": [[0, 0, 0]], ";

    static final List<BadLevel> ALL = List.of(
            billboards(".at", "list places in at, or give it a field", SIZE),
            billboards(".facing", "must be one of [spherical, cylindrical", HERE + "\"facing\": \"eye\", " + SIZE),
            billboards(".sizeMetres", "2 numbers, [width, height]", HERE + "\"sizeMetres\": [1, 2, 3]"),
            billboards(".sizeMetres[1]", "must be from 0.01 to 1000", HERE + "\"sizeMetres\": [1, 0]"),
            billboards(".at[0][1]", "must be from", "\"at\": [[0, 1e9, 0]], " + SIZE),
            billboards(".frames", "must be from 1 to 64", HERE + "\"frames\": 0, " + SIZE),
            billboards(".colourKey", "three numbers", HERE + "\"colourKey\": [0, 0], " + SIZE),
            billboards(".heightVariation", "must be from 0 to 1", HERE + "\"heightVariation\": 1.5, " + SIZE),
            billboards(".sprite", "there is no such file", HERE + SIZE),
            billboards(".field", "keep one of the two", HERE + field(3, 1, "") + SIZE),
            billboards(".field.terrain", "there is no terrain 'hills'", field(3, 1, ", \"terrain\": \"hills\"") + SIZE),
            billboards(".field.count", "must be from 1 to 200000", field(0, 1, "") + SIZE),
            billboards(".field.spacingMetres", "must be from 0.01", field(3, 0, "") + SIZE),
            billboards(
                    ".field.heightRangeMetres",
                    "the lowest height comes first",
                    field(3, 1, ", \"heightRangeMetres\": [2, 1]") + SIZE),
            billboards(".field.count", "fit at spacingMetres 4", field(100, 4, "") + SIZE),
            billboards(".field.count", "0 fit at", field(3, 1, ", \"heightRangeMetres\": [5, 9]") + SIZE),
            billboards(
                    ".field.densityMap", "there is no such file", field(3, 1, ", \"densityMap\": \"none.png\"") + SIZE),
            level(
                    "billboards[0].field",
                    "add a terrain, a solid or a model",
                    "\"billboards\": [{\"id\": \"b\", \"sprite\": \"s.png\", " + field(3, 1, "") + SIZE + "}]"),
            level(
                    "billboards[1]",
                    "at most 200000 billboards",
                    GROUND + "\"billboards\": [" + one("a", field(200_000, 0.02, "")) + ", " + one("b", field(1, 1, ""))
                            + "]"),
            level(
                    "billboards[1].id",
                    "give it another",
                    "\"billboards\": [" + one("a", HERE) + ", " + one("a", HERE) + "]"));

    private BadBillboards() {}

    private static String field(int count, double spacing, String more) {
        return "\"field\": {\"count\": " + count + ", \"spacingMetres\": " + spacing + more + "}, ";
    }

    private static String one(String id, String members) {
        return "{\"id\": \"" + id + "\", \"sprite\": \"s.png\", " + members + SIZE + "}";
    }

    private static BadLevel billboards(String path, String words, String members) {
        return level(
                "billboards[0]" + path,
                words,
                GROUND + "\"billboards\": [{\"id\": \"b\", \"sprite\": \"s.png\", " + members + "}]");
    }
}
