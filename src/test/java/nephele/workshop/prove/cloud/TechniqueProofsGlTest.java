package nephele.workshop.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.lab.technique.TableCase;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** Tests the proofs about techniques at a reduced count, and the nodes of their table. */
class TechniqueProofsGlTest {
    private static final int FEW_SAMPLES = 24;
    /** The heap of puffs, the sun at 30 degrees, the second place. */
    private static final long HEAP = 9L * 9 + 4;

    @Test
    void choiceForAHeapOfPuffsIsInside() {
        ProofResult result = new CloudAutoProof(FEW_SAMPLES, false).run(HEAP, 1, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        assertFalse(result.figures().isEmpty());
    }

    @Test
    void thinLensHasTheTracersRadiance() {
        ProofResult result = new CloudRadianceProof(FEW_SAMPLES).run(0, 1, Proof.Progress.NONE);
        Figure bias = result.figures().get(0);
        assertEquals("volume, volume ellipsoid of optical depth 0.3", bias.name());
        assertEquals(0, bias.value(), 8);
    }

    @Test
    void eyeOfTheLastAngleIsInsideEachFiniteCloud() {
        List<TableCase> nodes = TableCase.all();
        assertEquals(12, nodes.stream().map(TableCase::form).distinct().count());
        for (TableCase at : nodes) {
            if (at.isCrossed()) {
                var box = (Cloud.Extent.Volume)
                        at.sky().level().environment().clouds().get(0).extent();
                Vec3 eye = at.sky().view().eye();
                assertTrue(Aabb.around(box.centre(), box.size()).contains(eye.x(), eye.y(), eye.z()), at.form());
            }
        }
    }
}
