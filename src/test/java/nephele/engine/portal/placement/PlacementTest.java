package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import org.junit.jupiter.api.Test;

/** Placement of portals that overlap or barely fit, and every reason for a refusal. */
class PlacementTest {
    private static final Gun RECTANGLE = Walls.gun(PortalShape.RECTANGLE, 1.2, 2.1);

    private static void assertCentre(double x, double y, PlacementResult placed) {
        Vec3 centre = Walls.fits(placed).centre();
        assertEquals(x, centre.x(), 1e-6);
        assertEquals(y, centre.y(), 1e-6);
        assertEquals(0, centre.z(), 1e-9);
    }

    @Test
    void whereThereIsRoomThePortalIsWhereOneAims() {
        PlacementResult placed = new Walls().wall(-5, 0, 5, 4).shoot(Walls.ARCH, 0.3, 1.9);
        assertCentre(0.3, 1.9, placed);
        assertEquals(0, ((PlacementResult.Fits) placed).slideMetres());
        Portal portal = Walls.fits(placed);
        assertEquals(Basis.WORLD, portal.frame());
        assertEquals("p", portal.id());
    }

    @Test
    void aNearMissSlidesIntoPlace() {
        Walls wall = new Walls().wall(-5, 0, 5, 4);
        assertCentre(0, 1.05, wall.shoot(Walls.ARCH, 0, 0.5));
        assertCentre(4.4, 1.05, wall.shoot(RECTANGLE, 4.8, 0.8));
        assertEquals(Refusal.EDGE, Walls.refused(wall.shoot(Walls.ARCH, 0, 0.2)));
    }

    @Test
    void aWallAsLargeAsTheApertureFitsAndOneSmallerByAMillimetreDoesNot() {
        assertCentre(0.1, -0.2, new Walls().wall(-0.5, -1.25, 0.7, 0.85).shoot(RECTANGLE, 0.3, 0.1));
        assertCentre(0.1, -0.2, new Walls().wall(-0.5, -1.25, 0.7, 0.85).shoot(Walls.ARCH, 0.3, 0.1));
        Walls narrow = new Walls().wall(-0.5, -1.25, 0.699, 0.85);
        Walls low = new Walls().wall(-0.5, -1.25, 0.7, 0.849);
        for (Gun gun : List.of(RECTANGLE, Walls.ARCH)) {
            assertEquals(Refusal.TOO_SMALL, Walls.refused(narrow.shoot(gun, 0.3, 0.1)));
            assertEquals(Refusal.TOO_SMALL, Walls.refused(low.shoot(gun, 0.3, 0.1)));
        }
    }

    @Test
    void aHoleAMillimetreInsidePushesThePortalAsideByThat() {
        Walls holed =
                new Walls().wall(-5, 0, 0, 4).wall(0, 0, 5, 1).wall(0, 2, 5, 4).wall(1, 1, 5, 2);
        assertCentre(-0.6, 1.5, holed.shoot(RECTANGLE, -0.599, 1.5));
        assertCentre(-0.6, 1.5, holed.shoot(RECTANGLE, -0.6, 1.5));
        assertCentre(-0.601, 1.5, holed.shoot(RECTANGLE, -0.601, 1.5));
    }

    @Test
    void facesWithoutLeaveAndWhatStandsAgainstTheWallAreKeptFreeOf() {
        Walls panel = new Walls().wall(-5, 0, 0, 4).without(0, 0, 5, 4);
        assertCentre(-0.6, 2, panel.shoot(RECTANGLE, -0.1, 2));
        assertEquals(Refusal.NOT_PORTALABLE, Walls.refused(panel.shoot(RECTANGLE, 0.1, 2)));
        Walls pillar = new Walls().wall(-5, 0, 5, 4).box(0, 0, -0.5, 1, 4, 0.5, false);
        assertCentre(-0.6, 2, pillar.shoot(RECTANGLE, -0.1, 2));
        Walls step = new Walls().wall(-5, 0, 5, 4).box(-5, -1, 0, 5, 0.3, 1, true);
        assertCentre(0, 1.35, step.shoot(Walls.ARCH, 0, 1));
        Walls room = new Walls().wall(-5, 0, 5, 4).box(1, 0, -1, 2, 4, 5, true);
        assertCentre(0.4, 2, room.shoot(RECTANGLE, 0.9, 2));
        Walls apart = new Walls().wall(-5, 0, 5, 4).box(0, 0, 0.02, 1, 4, 0.5, false);
        assertCentre(-0.1, 2, apart.shoot(RECTANGLE, -0.1, 2));
    }

    @Test
    void anotherPortalMayTouchButNotOverlap() {
        Walls wall = new Walls().wall(-5, 0, 5, 4);
        Portal other = Walls.fits(wall.shoot(RECTANGLE, 0, 2));
        assertCentre(1.2, 2, wall.shoot(RECTANGLE, 1.2, 2, other));
        assertCentre(1.2, 2, wall.shoot(RECTANGLE, 1.2 - 1e-6, 2, other));
        assertCentre(1.2, 2, wall.shoot(RECTANGLE, 0.6, 2, other));
        assertEquals(Refusal.OVERLAPS_OTHER, Walls.refused(wall.shoot(RECTANGLE, 0.1, 2, other)));
        assertEquals(Refusal.EDGE, Walls.refused(wall.shoot(RECTANGLE, 0.1, 0.1, other)));
        Portal behind = new Portal("q", new Vec3(0, 2, -1), other.frame(), other.aperture());
        assertCentre(0.1, 2, wall.shoot(RECTANGLE, 0.1, 2, behind));
    }

    @Test
    void aShotThatMeetsNothingOrSomethingThatMovesIsRefused() {
        Walls wall = new Walls().wall(-5, 0, 5, 4);
        assertEquals(Refusal.NOTHING_HIT, Walls.refused(wall.shoot(RECTANGLE, 6, 2)));
        Gun near = new Gun(RECTANGLE.aperture(), 4.9, 0.75);
        assertEquals(Refusal.OUT_OF_RANGE, Walls.refused(wall.shoot(near, 0, 2)));
        ShotRay aim = new ShotRay(new Vec3(0, 2, 5), Basis.WORLD);
        Placement placement = new Placement(wall.surfaces(), RECTANGLE);
        Obstacles box = (from, path) -> 3 / path.length();
        PlacementResult.Refused moving = (PlacementResult.Refused) placement.place("p", aim, List.of(), box);
        assertEquals(Refusal.MOVING_SURFACE, moving.reason());
        assertEquals(new Vec3(0, 2, 2), moving.where());
        Obstacles behind = (from, path) -> 1;
        assertCentre(0, 2, placement.place("p", aim, List.of(), behind));
    }

    @Test
    void theHostIsNotSeenFromWithinButWhatLiesBeyondIs() {
        Walls wall = new Walls().wall(-5, 0, 5, 4).box(-5, 0, 4.5, 5, 4, 6, false);
        assertCentre(0, 2, wall.shoot(RECTANGLE, 0, 2));
        assertTrue(wall.surfaces().regions() > 0);
    }

    @Test
    void theOtherSideOfAGapCountsAsFarAsAPortalSlides() {
        Walls gap = new Walls().wall(-5, 0, 0, 4).wall(0.3, 0, 5, 4).wall(-5, 0, 5, 0.5);
        assertCentre(-0.6, 2, gap.shoot(RECTANGLE, -0.01, 2));
        assertCentre(0.9, 2, gap.shoot(RECTANGLE, 0.31, 2));
    }
}
