package nephele.editor.proving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.editor.action.ScriptedSession;
import nephele.editor.text.EditorRefusal;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.host.compare.TechniquePair;
import nephele.host.compare.Wipe;
import org.junit.jupiter.api.Test;

/** The comparison in the inspector, from a script: everything is drawn at once. */
class TechniqueComparisonGlTest {
    private static ScriptedSession clouded() {
        return ScriptedSession.of(new TestLevel()
                .sky(new Sky.Constant(new Vec3(0.2, 0.3, 0.5)))
                .sun(new Vec3(0.5, 0.6, 0.6), 3)
                .cloud(new Cloud(
                        "heap",
                        new Cloud.Extent.Volume(Vec3.ZERO, new Vec3(60, 40, 40)),
                        CloudTechnique.BILLBOARD,
                        new Cloud.Density.Puffs(List.of(new Cloud.Puff(Vec3.ZERO, 14)), null),
                        0.05,
                        0.95,
                        0.6))
                .level());
    }

    private static int middle(ComparedPictures pictures) {
        return pictures.left().getRGB(160, 90);
    }

    @Test
    void aScriptComparesAndAnEditIsDrawnAgain() {
        ScriptedSession session = clouded();
        TechniqueComparison comparison = session.session().proving().techniques();
        session.run("select environment.clouds/heap", "focus", "compare-techniques b=particles wipe=0.4");
        assertEquals(new TechniquePair(CloudTechnique.BILLBOARD, CloudTechnique.PARTICLES), comparison.techniques());
        assertEquals(new Wipe(0.4), comparison.wipe());
        ComparedPictures thick = comparison.pictures().orElseThrow();
        assertNull(thick.failure());
        assertTrue(thick.figures().difference().flip() > 0, thick.figures().toString());
        session.run("set extinctionPerMetre to=0.001");
        ComparedPictures thin = comparison.pictures().orElseThrow();
        assertNotEquals(middle(thick), middle(thin));
        session.run("compare-techniques show=false", "set technique to=volume");
        assertTrue(comparison.pictures().isEmpty());
        assertEquals(CloudTechnique.VOLUME, comparison.techniques().left(), "the left side is the cloud's own");
    }

    @Test
    void wrongNamesAreAnsweredWithAllAndALevelWithoutCloudsRefuses() {
        var script = clouded().script();
        var wrong = assertThrows(EditorRefusal.class, () -> script.run("compare-techniques a=puffs"));
        assertTrue(wrong.getMessage().contains("billboard, particles, volume"), wrong.getMessage());
        var empty = ScriptedSession.empty().script();
        assertThrows(EditorRefusal.class, () -> empty.run("compare-techniques"));
    }
}
