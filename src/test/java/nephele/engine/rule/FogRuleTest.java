package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.engine.level.Environment;
import nephele.engine.level.Problem;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** A sky behind fog without end is warned of: nobody sees it. */
class FogRuleTest {
    private static final Vec3 GREY = TestLevel.grey(0.5);

    private static List<String> paths(TestLevel level) {
        return LevelRules.check(List.of(EnvironmentRules.FOG), level.level(), null, null).stream()
                .map(Problem::path)
                .toList();
    }

    @Test
    void onlyASkyBehindFogWithoutEndIsWarnedOf() {
        assertEquals(List.of("environment.fog"), paths(foggy(0.1, 0).sky(new Sky.Constant(GREY))));
        assertEquals(List.of(), paths(foggy(0.1, 0)));
        assertEquals(List.of(), paths(foggy(0, 0).sky(new Sky.Constant(GREY))));
        assertEquals(List.of(), paths(foggy(0.1, 30).sky(new Sky.Constant(GREY))));
    }

    private static TestLevel foggy(double extinctionPerMetre, double scaleHeightMetres) {
        return new TestLevel().fog(new Environment.Fog(extinctionPerMetre, GREY, 0, scaleHeightMetres));
    }
}
