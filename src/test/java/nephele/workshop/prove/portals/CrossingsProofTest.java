package nephele.workshop.prove.portals;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The proof holds at a reduced count. */
@Execution(ExecutionMode.CONCURRENT)
final class CrossingsProofTest {
    @Test
    void nobodyFallsThroughOrStaysInASolid() {
        ProofResult result = new CrossingsProof().run(0, 300, Proof.Progress.NONE);
        assertEquals(0, result.failures(), () -> String.join("\n", result.examples()));
        assertEquals(300, result.figures().get(0).value(), "crossings");
    }

    /** Portals occur on every wall, floor, ceiling and slanted block. */
    @Test
    void roomsHavePortalsOnEveryFace() {
        Set<Vec3> normals = new HashSet<>();
        for (int room = 0; room < 200; room++) {
            Portals portals = PortalRoom.of(new SplittableRandom(room)).portals();
            normals.add(portals.portal(0).normal());
            normals.add(portals.portal(1).normal());
        }
        List<Vec3> axes = List.of(
                new Vec3(1, 0, 0),
                new Vec3(-1, 0, 0),
                new Vec3(0, 1, 0),
                new Vec3(0, -1, 0),
                new Vec3(0, 0, 1),
                new Vec3(0, 0, -1));
        assertTrue(normals.containsAll(axes), normals.toString());
        assertTrue(normals.size() > axes.size(), "none is slanted");
    }

    /** Balls, boxes and capsules are thrown. */
    @Test
    void everyKindOfBodyIsThrown() {
        Set<Class<?>> kinds = new HashSet<>();
        PortalRoom room = PortalRoom.of(new SplittableRandom(0));
        for (int seed = 0; seed < 50; seed++) {
            kinds.add(new CrossingBodies(room, 120, seed).body().getClass());
        }
        assertEquals(Set.of(Body.Box.class, Body.Sphere.class, Body.Capsule.class), kinds);
    }
}
