package nephele.mutants;

import static nephele.mutants.Mutant.Area.LEVEL;
import static nephele.mutants.Mutants.ENGINE;

import java.util.List;

/** Faults in the reading of levels and in their rules. */
final class LevelMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    LEVEL,
                    "a key behind the thirty-second counts as another one",
                    ENGINE + "level/json/JsonValue.java",
                    "asked |= 1L << index;",
                    "asked |= 1 << index;",
                    "LevelBoundsTest"),
            new Mutant(
                    LEVEL,
                    "a list may not be as long as it may",
                    ENGINE + "level/json/CollectionFormats.java",
                    "array.values().size() > most",
                    "array.values().size() >= most",
                    "LevelBoundsTest"),
            new Mutant(
                    LEVEL,
                    "the least number allowed is refused",
                    ENGINE + "level/NumberRange.java",
                    "return number >= min && number <= max;",
                    "return number > min && number <= max;",
                    "LevelBoundsTest"),
            new Mutant(
                    LEVEL,
                    "a capsule without a straight part is refused",
                    ENGINE + "rule/BodyRules.java",
                    "capsule.heightMetres() < 2 * capsule.radiusMetres()",
                    "capsule.heightMetres() <= 2 * capsule.radiusMetres()",
                    "LevelBoundsTest"),
            new Mutant(
                    LEVEL,
                    "models may share an id",
                    ENGINE + "rule/IdRules.java",
                    "unique(\"models\", level.models(), ModelPlacement::id, report);",
                    "",
                    "LevelBoundsTest"),
            new Mutant(
                    LEVEL,
                    "a wedge falls towards the side it should rise to",
                    ENGINE + "level/Brush.java",
                    "new Vec3(-high.x() * rise, run, -high.z() * rise)",
                    "new Vec3(high.x() * rise, run, high.z() * rise)",
                    "BrushTest"));

    private LevelMutants() {}
}
