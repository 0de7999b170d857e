package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.junit.jupiter.api.Test;

class BodyDepthTest {
    private final BodyTable table = new BodyTable(List.of(
            new Body.Box("cube", Vec3.ZERO, new Vec3(.4, .4, .4), 1, null, .6, 0),
            new Body.Sphere("ball", Vec3.ZERO, .3, 1, null, .6, 0)));
    private final BodyDepth depth = new BodyDepth(
            table,
            PortalWorld.of(BoxPile.closedRoom(6, 6, 1), new Portals(List.of(floor(-3), floor(3)), List.of(1, 0))));

    private static Portal floor(double x) {
        return new Portal(
                "p" + x,
                new Vec3(x, 0, 0),
                Portal.facing(new Vec3(0, 1, 0), new Vec3(1, 0, 0)),
                Aperture.of(PortalShape.RECTANGLE, 1, 1));
    }

    private static Bodies at(Vec3 cube, Vec3 ball) {
        return Bodies.of(List.of(BodyState.resting(cube), BodyState.resting(ball)));
    }

    @Test
    void inTheFloorButNotInAPortal() {
        Bodies bodies = at(new Vec3(0, .197, 0), new Vec3(3, .1, 0));
        assertEquals(.003, depth.inSolids(bodies, 0), 1e-12);
        assertEquals(0, depth.inSolids(bodies, 1));
    }

    /** The ball reaches through the portal into the floor beside the aperture's rim. */
    @Test
    void inTheRimOfAPortal() {
        Bodies bodies = at(new Vec3(0, 2, 0), new Vec3(3.4, .1, 0));
        assertTrue(depth.inSolids(bodies, 1) > .05, () -> depth.inSolids(bodies, 1) + " m");
    }

    @Test
    void inEachOther() {
        Bodies bodies = at(new Vec3(0, 1, 0), new Vec3(.49, 1, 0));
        assertEquals(.01, depth.inBodies(bodies, 0), 1e-12);
        assertEquals(.01, depth.inBodies(bodies, 1), 1e-12);
        assertEquals(-.01, depth.gapMetres(bodies, 0, 1), 1e-12);
    }
}
