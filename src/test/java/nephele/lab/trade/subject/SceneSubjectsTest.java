package nephele.lab.trade.subject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.model.Mesh;
import nephele.engine.model.shape.ConeShape;
import nephele.scenes.xml.PosedScene;
import nephele.scenes.xml.XmlScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class SceneSubjectsTest {
    /** For radius 1 and height 2 the report's normal rises by 41.8° halfway up, the exact one by 26.6°. */
    @Test
    void theReportsConeFacesTooHighHalfwayUp() {
        Mesh cone = new ConeShape(1, 2, 8, 2).mesh();
        assertEquals(26.565, rise(cone), 1e-3);
        assertEquals(41.810, rise(SceneSubjects.withReportNormals(cone, 1, 2)), 1e-3);
    }

    /** Returns the normal's degrees above the horizontal, of the first point halfway up. */
    private static double rise(Mesh cone) {
        for (int i = 0; i < cone.vertexCount(); i++) {
            if (cone.positions()[3 * i + 1] == 1) {
                float[] n = cone.normals();
                return Math.toDegrees(Math.atan2(n[3 * i + 1], Math.hypot(n[3 * i], n[3 * i + 2])));
            }
        }
        throw new AssertionError("no point halfway up");
    }

    /** Each of the report's errors alone culls visible models, all together the most; exact spheres cull none. */
    @Test
    void onlyExactSpheresLeaveOutNothingThatIsSeen() {
        try (var experiment = new CullingSphereSubject()) {
            double all = experiment.judge(0).error();
            for (int alone = 1; alone < CullingSphereSubject.FAULTS.size(); alone++) {
                double one = experiment.judge(alone).error();
                assertTrue(one > 0.1 && one < all, alone + ": " + one + " % of " + all + " %");
            }
            assertEquals(0, experiment.judge(CullingSphereSubject.FAULTS.size()).error());
        }
    }

    @Test
    void stillLivesAreWithoutWarningsAndComplete() {
        var files = new StillLife.Generated();
        for (XmlScene scene : List.of(StillLife.of(4), StillLife.of(32), StillLife.cones(16))) {
            assertEquals(List.of(), scene.warnings());
            PosedScene posed = PosedScene.of(scene);
            for (int model = 0; model < posed.modelCount(); model++) {
                assertTrue(files.mesh(posed.model(model)).triangleCount() > 0);
            }
            assertTrue(posed.modelCount() >= 4 && posed.lightCount() == 2);
        }
    }
}
