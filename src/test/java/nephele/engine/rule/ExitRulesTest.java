package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import nephele.engine.level.Exit;
import nephele.engine.level.Problem;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Exits that a player cannot enter are reported, and ids are unique. */
class ExitRulesTest {
    private static List<Problem> problems(Exit... exits) {
        TestLevel level = new TestLevel().box(null, new Vec3(0, 1, 0), new Vec3(2, 4, 2));
        for (Exit exit : exits) {
            level.exit(exit);
        }
        return LevelRules.check(List.of(IdRules.UNIQUE, GuidanceRules.EXITS), level.level(), null, null);
    }

    @Test
    void anExitBesideSolidsIsGood() {
        assertEquals(List.of(), problems(new Exit("e", new Vec3(3, 0, 0), 1, 2)));
    }

    @Test
    void anExitInASolidIsAWarning() {
        List<Problem> found = problems(new Exit("e", new Vec3(0.2, 0, 0), 1, 2));
        assertEquals(List.of("exits[0].feet"), found.stream().map(Problem::path).toList());
        assertFalse(found.get(0).isError());
    }

    @Test
    void anExitBelowTheCentreIsAWarning() {
        List<Problem> found = problems(new Exit("e", new Vec3(3, 0, 0), 1, 0.8));
        assertEquals(
                List.of("exits[0].heightMetres"),
                found.stream().map(Problem::path).toList());
    }

    @Test
    void idsAreUnique() {
        Exit exit = new Exit("e", new Vec3(3, 0, 0), 1, 2);
        assertEquals(
                List.of("exits[1].id"),
                problems(exit, exit).stream().map(Problem::path).toList());
    }
}
