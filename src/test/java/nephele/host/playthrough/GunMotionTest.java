package nephele.host.playthrough;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.GunInHand;
import nephele.engine.scene.MuzzleLight;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.engine.scene.dynamic.DynamicInstances;
import nephele.engine.scene.dynamic.DynamicObjects;
import nephele.engine.scene.dynamic.GunMesh;
import nephele.engine.scene.dynamic.HeldBodyVisibility;
import nephele.engine.scene.dynamic.VisibleInstances;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.host.named.Viewpoints;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The gun in the hand and the light of its shots are functions of the ticks and their events. */
class GunMotionTest {
    private static final PlayerInput FIRST = PlayerInput.NONE.holding(Action.FIRE_FIRST);
    private static final PlayerInput SECOND = PlayerInput.NONE.holding(Action.FIRE_SECOND);

    private static HandWalk inHall() {
        return new HandWalk(RoomLevel.hall().gun().startAt(0, 0, 0, 0, 0).level());
    }

    private static GunInHand gun(HandWalk room) {
        return room.walk().frameState().gun();
    }

    @Test
    void theLampShowsTheNextPortal() {
        HandWalk room = inHall();
        assertEquals(0, gun(room).secondShare(), "the first shot");
        room.hold(FIRST).ticks(1).hold(PlayerInput.NONE);
        assertEquals(1, gun(room).flash(), "muzzle light");
        room.ticks(40);
        assertEquals(1, gun(room).secondShare(), 1e-9, "the second");
        room.hold(PlayerInput.NONE.turning(90_000, 0)).ticks(1);
        room.hold(SECOND).ticks(1).hold(PlayerInput.NONE).ticks(120);
        assertEquals(0, gun(room).secondShare(), 1e-9);
        assertEquals(0, gun(room).flash());
    }

    @Test
    void noGunWithoutOneAndInThirdPerson() {
        assertNull(gun(new HandWalk(RoomLevel.hall().level()).ticks(2)));
        HandWalk room = inHall();
        room.walk().changePerson();
        assertNull(gun(room.ticks(60)));
    }

    private static PlayerInput random(SplittableRandom random) {
        PlayerInput input = PlayerInput.NONE
                .walking(random.nextInt(-100, 101), random.nextInt(-100, 101))
                .turning(random.nextInt(-6000, 6001), random.nextInt(-3000, 3001));
        Action action = Action.ALL.get(random.nextInt(Action.ALL.size()));
        return random.nextInt(3) == 0 ? input.holding(action) : input;
    }

    /** The mesh has only the triangles that may face the eye. */
    @Test
    void wherePlayGoesTheEyeIsWhereTheMeshIsMadeFor() {
        SplittableRandom random = new SplittableRandom(3);
        HandWalk room = new HandWalk(RoomLevel.hall()
                .gun()
                .cube(new Vec3(0, 0.3, -1), 0.6, 20)
                .startAt(0, 2, 0, 0, -20)
                .level());
        for (int i = 0; i < 700; i++) {
            GunInHand gun = gun(room.hold(random(random)).ticks(1));
            for (double aspect : new double[] {0.5, 2}) {
                var eye = new Vector3d(
                        -gun.rightMetres(aspect), -gun.place().y(), -gun.place().z());
                new Quaterniond()
                        .rotateY(gun.yawRadians())
                        .rotateX(gun.pitchRadians())
                        .rotateZ(-gun.rollRadians())
                        .transformInverse(eye);
                assertTrue(GunMesh.EYES.contains(eye.x, eye.y, eye.z), "tick " + i + ": " + eye);
            }
        }
    }

    @Test
    void aReplayShowsTheSame() {
        HandWalk once = inHall();
        HandWalk again = inHall();
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < 200; i++) {
            PlayerInput input = random(random);
            once.hold(input).ticks(1);
            again.hold(input).ticks(1);
            assertEquals(gun(once), gun(again));
            assertEquals(
                    once.walk().frameState().muzzleLight(),
                    again.walk().frameState().muzzleLight());
            assertEquals(
                    once.walk().frameState().shotEffects(),
                    again.walk().frameState().shotEffects());
        }
    }

    @Test
    void withReducedMotionItIsStill() {
        HandWalk room = inHall();
        room.walk().motion(PictureMotion.REDUCED);
        Vec3 place = gun(room).place();
        room.hold(PlayerInput.FORWARD.turning(700, 300).holding(Action.JUMP));
        for (int i = 0; i < 60; i++) {
            assertEquals(place, gun(room.ticks(1)).place());
        }
    }

    @Test
    void aShotFliesToItsPlaceAndIsGone() {
        HandWalk room = inHall().hold(FIRST).ticks(1).hold(PlayerInput.NONE);
        FrameState.ShotEffect bolt = room.walk().frameState().shotEffects().get(0);
        assertEquals(FrameState.ShotEffect.Kind.BOLT, bolt.kind());
        assertEquals(-8, bolt.to().z(), 1e-6, "on the wall");
        assertTrue(room.ticks(60).walk().frameState().shotEffects().isEmpty());
    }

    /** Both persons' shots light the surroundings from the muzzle, and for a moment only. */
    @Test
    void aShotLightsItsSurroundingsForAMoment() {
        for (boolean isThird : new boolean[] {false, true}) {
            HandWalk room = inHall();
            if (isThird) {
                room.walk().changePerson();
                room.ticks(120);
            }
            assertNull(room.walk().frameState().muzzleLight(), "before");
            room.hold(FIRST).ticks(1).hold(PlayerInput.NONE);
            MuzzleLight light = room.walk().frameState().muzzleLight();
            assertEquals(1, light.strength());
            assertEquals(0, light.colour());
            Vec3 fromBody = light.place().minus(room.walk().state().player().centre());
            assertTrue(fromBody.length() < 1.6 && fromBody.z() < -0.3, "before the player: " + fromBody);
            assertNull(room.ticks(17).walk().frameState().muzzleLight(), "after");
        }
    }

    @Test
    void aRefusedShotShimmersOnItsSurface() {
        Level level = new RoomLevel()
                .box(-8, -1, -8, 8, 0, 8)
                .box(-9, -1, -9, 9, 7, -8, false)
                .gun()
                .startAt(0, 0, 0, 25, 10)
                .level();
        HandWalk room =
                new HandWalk(level).hold(FIRST).ticks(1).hold(PlayerInput.NONE).ticks(20);
        FrameState.ShotEffect shimmer = room.walk().frameState().shotEffects().stream()
                .filter(effect -> effect.kind() == FrameState.ShotEffect.Kind.SHIMMER)
                .findFirst()
                .orElseThrow();
        assertEquals(-8, shimmer.from().z(), 1e-6);
        assertEquals(1, shimmer.to().minus(shimmer.from()).z(), 1e-6, "along the normal");
    }

    /** A portal that is shot elsewhere closes where it was. */
    @Test
    void whereItWasAPortalCloses() {
        HandWalk room = inHall().hold(FIRST).ticks(1).hold(PlayerInput.NONE).ticks(30);
        assertTrue(room.walk().frameState().closing().isEmpty());
        room.hold(PlayerInput.NONE.turning(90_000, 0)).ticks(1);
        room.hold(FIRST).ticks(1).hold(PlayerInput.NONE);
        var closing = room.walk().frameState().closing().get(0);
        assertEquals(-8, closing.portal().centre().z(), 1e-3);
        assertEquals(1, closing.openness());
        double half = room.ticks(12).walk().frameState().closing().get(0).openness();
        assertTrue(half > 0.1 && half < 0.5, "openness " + half);
        assertTrue(room.ticks(20).walk().frameState().closing().isEmpty());
    }

    /** Looking down, the player sees one right forearm: the gun's. Whoever sees the body from elsewhere sees its own. */
    @Test
    void theGunsArmIsSeenInsteadOfTheBodys() {
        Level level = RoomLevel.hall().gun().startAt(0, 0, 0, 0, -60).level();
        Playthrough walk = new HandWalk(level).ticks(30).walk();
        var own = DynamicObjects.of(level, Scene.of(level, TestAssets.NONE).materials(), CharacterPresence.POSSIBLE);
        var copies = new DynamicInstances(own, Vec3.ZERO, null);
        FrameState frameState = walk.frameState();
        copies.update(frameState);
        View down = walk.view(1);
        View behind = Viewpoints.ofEye(down.eye().plus(new Vec3(0, 0, 2)), Basis.WORLD, 70, 1);
        int withGun = indices(own, copies, down, frameState);
        int fromBehind = indices(own, copies, behind, frameState);
        frameState.gun(null);
        assertTrue(withGun < indices(own, copies, down, frameState), "without the forearm");
        assertEquals(fromBehind, indices(own, copies, behind, frameState), "whole");
    }

    private static int indices(DynamicObjects own, DynamicInstances copies, View view, FrameState frameState) {
        var held = new HeldBodyVisibility(copies);
        held.find(view, frameState);
        var visible = new VisibleInstances(own, copies);
        visible.find(view, 90, held);
        assertEquals(1, visible.runs());
        return visible.mesh(0).count();
    }
}
