package nephele.engine.scene.dynamic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The pieces of an object in portals make up the whole object once, each on the right side of its plane. */
class PortalCopiesTest {
    private static final DynamicShape[] BOX = {new DynamicShape(DynamicShape.BOX, new Vec3(0.4, 0.3, 0.5), 0)};

    private static Portal portal(Vec3 centre, Vec3 normal) {
        Vec3 up = new Vec3(0.1, 1, 0.2);
        return Portal.of(new PortalSpec("p", "q", centre, normal, up, 4, 4, PortalShape.RECTANGLE));
    }

    private static PortalCopies placed(Vector3d centre, Quaterniond turn, DynamicShape[] shapes, Portals portals) {
        PortalCopies places = new PortalCopies();
        places.begin(1);
        places.place(0, centre, turn, centre);
        places.makeCopies(portals, shapes);
        return places;
    }

    private static Quaterniond randomTurn(Random random) {
        return new Quaterniond(
                        random.nextGaussian(), random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                .normalize();
    }

    private static boolean isBeforePlanes(PortalCopies places, int slot, Vector3d fromCentre) {
        for (int plane = 0; plane < places.planes(slot); plane++) {
            double before = places.plane(slot, plane, 3);
            for (int axis = 0; axis < 3; axis++) {
                before += places.plane(slot, plane, axis) * fromCentre.get(axis);
            }
            if (before < 0) {
                return false;
            }
        }
        return true;
    }

    /**
     * Any point of a box in a portal is in exactly one of its pieces, at the position given by the portal transform.
     */
    @Test
    void halvesMakeAWhole() {
        Random random = new Random(1);
        int images = 0;
        for (int run = 0; run < 1000; run++) {
            Portal entry = portal(new Vec3(1, 2, 3), new Vec3(random.nextGaussian(), random.nextGaussian(), 1));
            Portal exit = portal(new Vec3(-40, 7, 5), new Vec3(1, random.nextGaussian(), random.nextGaussian()));
            Portals portals = new Portals(List.of(entry, exit), List.of(1, 0));
            Vec3 at = entry.world(random.nextDouble() - 0.5, random.nextDouble() - 0.5, 0.6 * random.nextDouble());
            Quaterniond turn = randomTurn(random);
            PortalCopies places = placed(at.toVector(), turn, BOX, portals);
            images += places.copies() - 1;
            Vec3 half = BOX[0].half();
            for (int i = 0; i < 20; i++) {
                Vector3d local = new Vector3d(
                        half.x() * (2 * random.nextDouble() - 1),
                        half.y() * (2 * random.nextDouble() - 1),
                        half.z() * (2 * random.nextDouble() - 1));
                Vector3d p = turn.transform(local, new Vector3d()).add(at.toVector());
                boolean isBehind = entry.inFront(p.x, p.y, p.z) < 0;
                assertEquals(!isBehind, holds(places, 0, local), "host, " + run);
                if (places.copies() > 1) {
                    assertEquals(isBehind, holds(places, 1, local), "image, " + run);
                    assertImage(places, local, portals.transform(0).point(p));
                }
            }
        }
        assertTrue(images > 300 && images < 1000, "some straddle, some do not: " + images);
    }

    private static boolean holds(PortalCopies places, int copy, Vector3d local) {
        int slot = PortalCopies.slot(copy, 0);
        return isBeforePlanes(
                places, slot, places.orientation(slot, new Quaterniond()).transform(new Vector3d(local)));
    }

    private static void assertImage(PortalCopies places, Vector3d local, Vector3d expected) {
        int slot = PortalCopies.slot(1, 0);
        Vector3d p = places.orientation(slot, new Quaterniond()).transform(new Vector3d(local));
        p.add(places.centre(slot, new Vector3d()));
        assertEquals(0, p.distance(expected), 1e-12);
    }

    /** An object beside the opening or behind the portal is not cut, however far it extends beyond the plane. */
    @Test
    void whatIsBesideTheOpeningStaysWhole() {
        Portals portals = new Portals(
                List.of(portal(Vec3.ZERO, new Vec3(0, 0, 1)), portal(new Vec3(9, 0, 0), new Vec3(1, 0, 0))),
                List.of(1, 0));
        for (Vec3 at : List.of(new Vec3(0, 3, 0.1), new Vec3(-2.6, 0, 0.2), new Vec3(0, 0, -0.1))) {
            PortalCopies places = placed(at.toVector(), new Quaterniond(), BOX, portals);
            assertEquals(1, places.copies(), at.toString());
            assertEquals(0, places.planes(PortalCopies.slot(0, 0)), at.toString());
        }
        Portals closed = new Portals(List.of(portal(Vec3.ZERO, new Vec3(0, 0, 1))), List.of(Portals.CLOSED));
        assertEquals(
                1,
                placed(new Vector3d(0, 0, 0.1), new Quaterniond(), BOX, closed).copies());
    }

    /** A part has at most two clip planes: a third portal of the corner neither clips it nor makes an image. */
    @Test
    void inACornerOfThreePortalsNothingIsThereTwice() {
        List<Portal> all = new ArrayList<>();
        List<Integer> partners = new ArrayList<>();
        List<Vec3> axes = List.of(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1));
        for (int i = 0; i < 3; i++) {
            all.add(portal(Vec3.ZERO, axes.get(i)));
            all.add(portal(new Vec3(50 + 50 * i, 0, 0), new Vec3(0, 0, 1)));
            partners.addAll(List.of(2 * i + 1, 2 * i));
        }
        PortalCopies places = placed(new Vector3d(0.1, 0.1, 0.1), new Quaterniond(), BOX, new Portals(all, partners));
        assertEquals(2, places.planes(PortalCopies.slot(0, 0)));
        assertEquals(3, places.copies(), "the host and an image for each cut");
    }

    /**
     * A rod between facing portals that are closer than its length is divided by both into a finite number of slices.
     */
    @Test
    void aRodBetweenFacingPortalsIsCutIntoSlices() {
        DynamicShape[] rod = {new DynamicShape(DynamicShape.BOX, new Vec3(0.1, 0.1, 1.25), 0)};
        Portals portals = new Portals(
                List.of(portal(Vec3.ZERO, new Vec3(0, 0, 1)), portal(new Vec3(0, 0, 1), new Vec3(0, 0, -1))),
                List.of(1, 0));
        PortalCopies places = placed(new Vector3d(0.2, 0.1, 0.5), new Quaterniond(), rod, portals);
        double length = 0;
        List<Double> slices = new ArrayList<>();
        for (int copy = 0; copy < places.copies(); copy++) {
            double[] span = {-1.25, 1.25};
            int slot = PortalCopies.slot(copy, 0);
            double along = places.orientation(slot, new Quaterniond()).transform(new Vector3d(0, 0, 1)).z;
            for (int plane = 0; plane < places.planes(slot); plane++) {
                double slope = places.plane(slot, plane, 2) * along;
                double cut = -places.plane(slot, plane, 3) / slope;
                span[slope > 0 ? 0 : 1] = slope > 0 ? Math.max(span[0], cut) : Math.min(span[1], cut);
            }
            slices.add(span[1] - span[0]);
            length += span[1] - span[0];
        }
        assertEquals(2.5, length, 1e-9, "slices " + slices);
        assertTrue(places.copies() <= PortalCopies.MOST_COPIES);
    }
}
