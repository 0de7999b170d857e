package nephele.workshop.prove.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Chance;
import nephele.engine.math.Vec3;
import nephele.engine.model.bound.Bound;
import nephele.engine.model.bound.BoundedModel;
import nephele.engine.model.bound.OrientedBox;
import nephele.engine.model.bound.Pose;
import nephele.engine.model.shape.BoxShape;
import nephele.engine.model.shape.SphereShape;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BoundTest {
    private static final Pose STILL = new Pose(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), Vec3.ZERO);
    private static final Vec3[] FLAT = {new Vec3(0, 0, 0), new Vec3(1, 0, 0), new Vec3(0, 1, 0)};
    private static final BoundedModel CUBE = BoundedModel.of("cube", new BoxShape(1, 1).mesh());

    @Test
    void noVolumeMissesAContact() {
        ProofResult result = new CollisionBoundsProof().run(0, 1500, Proof.Progress.NONE);
        assertEquals(List.of(), result.examples());
        double before = Double.POSITIVE_INFINITY;
        for (String finer : List.of("axis aligned box", "oriented box", "hierarchy", "triangles")) {
            double contacts = result.value("contacts by " + finer);
            assertTrue(contacts > 0 && contacts < before, finer + ": " + contacts);
            before = contacts;
        }
    }

    /** A cube of edge 1 and one turned by 45 degrees about z, which reaches .7071 m along x. */
    @ParameterizedTest
    @CsvSource({"1.207, 0, 5", "1.208, 0, 1", "1, 0.75, 2", "1.74, 0, 0"})
    void volumesOfCubesTouchAtTheirDistance(double x, double y, int touching) {
        double half = Math.sqrt(0.5);
        var turned = new Pose(new Vec3(half, half, 0), new Vec3(-half, half, 0), new Vec3(0, 0, 1), new Vec3(x, y, 0));
        for (Bound bound : Bound.values()) {
            assertEquals(bound.ordinal() < touching, bound.touch(CUBE, STILL, CUBE, turned), bound.name());
        }
    }

    @ParameterizedTest
    @CsvSource({
        "0.2, 0.2, -0.5, 0.2, 0.2, 0.5, true", // pierces it
        "0.2, 0.2, 0.001, 0.2, 0.2, 0.5, false", // above it
        "0.8, 0.8, -0.5, 0.8, 0.8, 0.5, false", // passes beside its long edge
        "-1, 0.5, 0, 2, 0.5, 0, true", // in its plane, through it
        "-1, 1.5, 0, 2, 1.5, 0, false", // in its plane, beside it
        "0, 0, 0, 0, 0, 1, true" // shares a corner
    })
    void trianglesTouchWhereASegmentDoes(
            double x1, double y1, double z1, double x2, double y2, double z2, boolean touch) {
        Vec3[] thin = {new Vec3(x1, y1, z1), new Vec3(x2, y2, z2), new Vec3(x2, y2, z2 + 1e-7)};
        assertEquals(touch, Bound.haveCommonPoint(FLAT, thin));
        assertEquals(touch, Bound.haveCommonPoint(thin, FLAT));
    }

    @Test
    void turningBothChangesNothing() {
        BoundedModel ball = BoundedModel.of("ball", new SphereShape(0.5, 12, 8).mesh());
        for (int i = 0; i < 300; i++) {
            long dice = Chance.dice(7, i);
            Pose at = Pose.random(dice, 0, new Vec3(0.6 + 0.8 * Chance.unit(dice, 3), 0, 0));
            Pose world = Pose.random(dice, 4, new Vec3(5, -3, 2));
            var turned = new Pose(
                    world.moved(at.x()).minus(world.at()),
                    world.moved(at.y()).minus(world.at()),
                    world.moved(at.z()).minus(world.at()),
                    world.moved(at.at()));
            for (Bound bound : List.of(Bound.SPHERE, Bound.ORIENTED_BOX, Bound.TRIANGLES)) {
                assertEquals(
                        bound.touch(CUBE, STILL, ball, at), bound.touch(CUBE, world, ball, turned), bound + " " + i);
            }
        }
    }

    @Test
    void uprightBoxContainsTheTurnedOne() {
        var box = new Aabb(-1, -0.2, -3, 1, 0.4, 2);
        for (int i = 0; i < 100; i++) {
            Pose at = Pose.random(Chance.dice(3, i), 0, new Vec3(i, 0, 0));
            Aabb upright = OrientedBox.of(box, at).upright();
            for (int corner = 0; corner < 8; corner++) {
                Vec3 place = at.moved(new Vec3(
                        (corner & 1) == 0 ? box.minX() : box.maxX(),
                        (corner & 2) == 0 ? box.minY() : box.maxY(),
                        (corner & 4) == 0 ? box.minZ() : box.maxZ()));
                assertTrue(upright.contains(place.x(), place.y(), place.z()));
            }
        }
    }
}
