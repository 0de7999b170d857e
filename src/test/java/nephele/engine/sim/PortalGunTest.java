package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.PortalGun;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.GunPortals.Colour;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.PortalOpened;
import nephele.engine.sim.state.TickEvent.PortalRefused;
import nephele.engine.sim.state.WorldState;
import nephele.engine.sim.state.WorldState.HeldBody;
import nephele.engine.sim.state.WorldState.TickTrace;
import org.junit.jupiter.api.Test;

/** The effects of shots: the portals that they place or refuse, and the occupants of portals that they move. */
final class PortalGunTest {
    private static final PlayerInput FORWARD = PlayerInput.FORWARD;

    /**
     * Returns a hall with the first portal in the wall ahead and the second in the wall to the right, both down to the
     * floor.
     */
    private static Lab twoPortals() {
        return Lab.hall()
                .gun()
                .startAt(0, 0, 0, 0, -5)
                .press(Action.FIRE_FIRST)
                .turn(-90, 0)
                .press(Action.FIRE_SECOND);
    }

    private static Portals portals(Lab lab) {
        return lab.state().world().portals();
    }

    @Test
    void withoutAGunNothingIsShot() {
        Lab lab = Lab.hall().press(Action.FIRE_FIRST).press(Action.FIRE_SECOND);
        assertEquals(WorldState.NOTHING, lab.state().world());
        assertNull(lab.simulation().aim(lab.state(), Colour.FIRST));
    }

    /** A single portal is closed and solid; two lead to each other. */
    @Test
    void oneAloneIsSolidAndTwoLeadToEachOther() {
        Lab lab = Lab.hall().gun().startAt(0, 0, 0, 0, -5).press(Action.FIRE_FIRST);
        assertEquals(List.of(new PortalOpened(Colour.FIRST, 0)), lab.events());
        Portal first = portals(lab).portal(0);
        assertEquals(-8, first.centre().z(), 1e-9);
        assertFalse(portals(lab).isOpen(0));
        lab.hold(FORWARD, 3);
        assertEquals(-8 + 0.3 + 0.001, lab.player().feet().z(), 1e-4);

        lab = twoPortals();
        assertEquals(new GunPortals(0, 1), lab.state().world().shots());
        assertEquals(1, portals(lab).partner(0));
        assertEquals(0, portals(lab).partner(1));
        lab.turn(90, 0).hold(FORWARD, 3);
        assertTrue(lab.player().feet().x() < 7, "came out of the right wall: " + lab.player());
        assertTrue(lab.player().feet().z() > -3, "and left the far one behind: " + lab.player());
    }

    @Test
    void anotherShotMovesItsPortalAndKeepsTheIndex() {
        Lab lab = twoPortals();
        Portal second = portals(lab).portal(1);
        lab.turn(-90, 0).press(Action.FIRE_FIRST);
        assertEquals(8, portals(lab).portal(0).centre().z(), 1e-9);
        assertEquals(second, portals(lab).portal(1));
        assertTrue(portals(lab).isOpen(0) && portals(lab).isOpen(1));
        assertEquals(new PortalOpened(Colour.FIRST, 0), lab.events().get(2));
    }

    @Test
    void fixedPairsComeFirstAndStay() {
        Vec3 a = new Vec3(-5, 1.05, -8);
        Vec3 b = new Vec3(5, 1.05, -8);
        Vec3 n = new Vec3(0, 0, 1);
        Lab lab = Lab.hall().gun().pair(a, n, b, n);
        lab.turn(90, 0).press(Action.FIRE_SECOND).turn(-180, 0).press(Action.FIRE_FIRST);
        assertEquals(new GunPortals(3, 2), lab.state().world().shots());
        assertEquals(
                List.of(1, 0, 3, 2),
                List.of(0, 1, 2, 3).stream().map(portals(lab)::partner).toList());
    }

    @Test
    void aRefusalSaysWhyAndChangesNothing() {
        Lab lab = Lab.hall().gun().box(-1, 0, -3, 1, 3, -2, false);
        long portalsBefore = portals(lab).size();
        lab.tick(PlayerInput.NONE.holding(Action.FIRE_FIRST));
        PortalRefused events =
                assertInstanceOf(PortalRefused.class, lab.events().get(0));
        assertEquals(Refusal.NOT_PORTALABLE, events.reason());
        assertEquals(-2, events.where().z(), 1e-9);
        assertEquals(portalsBefore, portals(lab).size());
        assertEquals(List.of(events), lab.state().world().trace().events());
        lab.tick(PlayerInput.NONE);
        assertEquals(List.of(), lab.state().world().trace().events());
    }

    @Test
    void aBodyStopsAShot() {
        Lab lab = Lab.hall().gun().cube(new Vec3(0, 1.65, -3), 1, 5).press(Action.FIRE_FIRST);
        assertEquals(Refusal.MOVING_SURFACE, ((PortalRefused) lab.events().get(0)).reason());
    }

    /** The portal preview shows the portal that the shot places. */
    @Test
    void thePreviewIsTheShot() {
        Lab lab = Lab.hall().gun().startAt(1, 0, 2, 37, -20);
        PlacementResult.Fits preview = (PlacementResult.Fits) lab.simulation().aim(lab.state(), Colour.FIRST);
        lab.press(Action.FIRE_FIRST);
        assertEquals(preview.portal(), portals(lab).portal(0));
    }

    /**
     * A horizontal shot at eye height opens a portal that one walks into; without the aid, or where the level forbids
     * it, its lower edge stays 60 cm above the floor. The portal preview shows it.
     */
    @Test
    void aShotAtEyeHeightCanBeWalkedInto() {
        for (boolean helped : new boolean[] {true, false}) {
            Lab lab = Lab.hall()
                    .gun()
                    .with(new SimSettings(120, helped ? Assist.USUAL : List.of()))
                    .press(Action.FIRE_FIRST)
                    .turn(90, 0);
            PlacementResult.Fits preview =
                    (PlacementResult.Fits) lab.simulation().aim(lab.state(), Colour.SECOND);
            lab.press(Action.FIRE_SECOND);
            assertEquals(preview.portal(), portals(lab).portal(1));
            assertEquals(helped ? 1.05 : 1.65, preview.portal().centre().y(), 1e-6);
            lab.hold(FORWARD, 4);
            assertEquals(
                    helped,
                    lab.player().feet().z() > -7.5 && lab.player().feet().x() > -7.5);
        }
    }

    @Test
    void aLevelMayForbidThatPortalsSlideDown() {
        Level level = Lab.hall().gun().level();
        PortalGun gun = level.portalGun();
        PortalGun forbids = new PortalGun(gun.widthMetres(), gun.heightMetres(), gun.shape(), gun.rangeMetres(), false);
        for (PortalGun its : List.of(gun, forbids)) {
            Simulation simulation = new Simulation(level.with(level.player(), its), new SimSettings(120, Assist.USUAL));
            PlacementResult.Fits fits = (PlacementResult.Fits) simulation.aim(simulation.start(), Colour.FIRST);
            assertEquals(its == gun ? 1.05 : 1.65, fits.portal().centre().y(), 1e-6);
        }
    }

    /** On floors a portal turns to the right angles of the room. */
    @Test
    void onAFloorItTurnsToTheRoom() {
        for (double yaw : new double[] {10, -14, 80, 100}) {
            Lab lab = Lab.hall()
                    .gun()
                    .startAt(2, 0, 2, yaw, 0)
                    .with(new SimSettings(120, Assist.USUAL))
                    .turn(0, -70)
                    .press(Action.FIRE_FIRST);
            Vec3 up = portals(lab).portal(0).frame().up();
            assertEquals(Math.abs(yaw) < 45 ? -1 : 0, up.z(), 1e-9);
            assertEquals(Math.abs(yaw) < 45 ? 0 : -1, up.x(), 1e-9);
        }
    }

    /** A shot goes through no portal: aimed into one, it ends in this room. */
    @Test
    void aShotGoesThroughNoPortal() {
        Lab lab = twoPortals();
        Portals before = portals(lab);
        lab.turn(90, 0).press(Action.FIRE_SECOND);
        // Through the first portal it would have come out of the second and hit the wall to the left.
        PortalRefused inTheWay = (PortalRefused) lab.events().get(2);
        assertEquals(Refusal.OVERLAPS_OTHER, inTheWay.reason());
        assertEquals(-8, inTheWay.where().z(), 1e-9);
        assertEquals(before, portals(lab));
        Vec3 a = new Vec3(0, 1.05, -4);
        Lab free = Lab.hall().gun().pair(a, new Vec3(0, 0, 1), new Vec3(5, 1.05, -8), new Vec3(0, 0, 1));
        free.press(Action.FIRE_FIRST);
        PortalRefused refused = (PortalRefused) free.events().get(0);
        assertEquals(Refusal.OVERLAPS_OTHER, refused.reason());
        assertEquals(-4, refused.where().z(), 1e-9);
    }

    /** A portal shot straight down has a finite orientation, which follows the yaw. */
    @Test
    void straightDownIsFinite() {
        for (double yaw : new double[] {0, 33, 90, -170}) {
            Lab lab = Lab.hall().gun().startAt(2, 0, 2, yaw, 0).turn(0, -89.9).press(Action.FIRE_FIRST);
            Portal floor = portals(lab).portal(0);
            assertEquals(new Vec3(0, 1, 0), floor.normal());
            assertEquals(
                    -StrictMath.sin(Math.toRadians(yaw)), floor.frame().up().x(), 1e-6);
            assertEquals(
                    -StrictMath.cos(Math.toRadians(yaw)), floor.frame().up().z(), 1e-6);
        }
    }

    /** A player in a portal that is moved is put on its centre's side within the tick, and never into a wall. */
    @Test
    void whoStandsInAMovedPortalIsPutOnTheCentresSide() {
        for (double before : new double[] {0.002, 0.1, 0.2, 0.29}) {
            for (Action moved : List.of(Action.FIRE_FIRST, Action.FIRE_SECOND)) {
                Lab lab = twoPortals();
                Portal first = portals(lab).portal(0);
                Vec3 feet = new Vec3(first.centre().x(), 0, -8 + before);
                lab.set(lab.state().withPlayer(lab.player().withFeet(feet)));
                lab.hold(PlayerInput.NONE, 0.1);
                assertEquals(before, lab.player().feet().z() + 8, 1e-9);
                // Aimed to the left, where no portal is yet.
                lab.turn(180, 0).tick(PlayerInput.NONE.holding(moved));
                assertInstanceOf(
                        PortalOpened.class, lab.events().get(2), lab.events().toString());
                Vec3 now = lab.player().feet();
                boolean pushed = moved == Action.FIRE_FIRST;
                assertEquals(pushed ? 0.301 : before, now.z() + 8, 1e-6);
                assertEquals(feet.x(), now.x(), 1e-6);
                lab.hold(PlayerInput.NONE, 0.1);
                assertEquals(now, lab.player().feet());
            }
        }
    }

    /** If the player in it has no room, the portal stays where it is. */
    @Test
    void withoutRoomTheShotIsRefused() {
        Lab lab = twoPortals();
        Lab narrow = Lab.hall().gun().startAt(0, 0, 0, 0, -5).box(-1, 0, -7.65, 1, 4, -7.5, false);
        Vec3 feet = new Vec3(0, 0, -7.95);
        narrow.set(lab.state().withPlayer(lab.player().withFeet(feet))).turn(180, 0);
        Portals before = portals(narrow);
        narrow.press(Action.FIRE_FIRST);
        assertEquals(Refusal.OCCUPIED, ((PortalRefused) narrow.events().get(0)).reason());
        assertEquals(before, portals(narrow));
        assertEquals(0, feet.toVector().distance(narrow.player().feet().toVector()), 0.002);
    }

    @Test
    void everyPartOfWhatCanChangeIsInTheHash() {
        WorldState around = twoPortals().state().world();
        CrossingWord word = CrossingWord.EMPTY.then(0, around.portals());
        HeldBody held = new HeldBody(0, CrossingWord.EMPTY, 0);
        List<WorldState> all = List.of(
                around,
                WorldState.NOTHING,
                around.with(Portals.NONE, around.shots()),
                around.with(around.portals(), new GunPortals(1, 0)),
                around.with(held),
                around.with(new HeldBody(0, word, 0)),
                around.with(held.unseenFor(1)),
                around.with(held.released()),
                around.with(TickTrace.of(8, CrossingWord.EMPTY, List.of())),
                around.with(TickTrace.of(0, word, List.of())),
                around.with(TickTrace.of(0, CrossingWord.EMPTY, List.of(TickEvent.Plain.NOTHING_IN_REACH))),
                around.with(TickTrace.of(0, CrossingWord.EMPTY, List.of(new PortalOpened(Colour.FIRST, 0)))));
        assertEquals(
                all.size(),
                all.stream().mapToLong(part -> part.hash(1)).distinct().count());
        assertEquals(1, WorldState.NOTHING.hash(1));
    }
}
