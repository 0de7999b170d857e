package nephele.app.prove;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.SeamedWorld;
import nephele.engine.collision.rigid.Bodies;
import nephele.engine.collision.rigid.BodyState;
import nephele.engine.collision.rigid.BodyTable;
import nephele.engine.collision.rigid.Influences;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.Surroundings;
import nephele.engine.level.Body;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import org.junit.jupiter.api.Test;

/** Awake bodies that may be so, and such that may not. */
class RestJudgeTest {
    private static final SeamedWorld WORLD = SeamedWorld.of(BoxPile.closedRoom(6, 6, 1), Portals.NONE);
    private static final Vec3 ROLL = new Vec3(1, 0, 0);

    private final List<Body> bodies = new ArrayList<>();
    private final List<BodyState> states = new ArrayList<>();

    private RestJudgeTest ball(double x, Vec3 velocity) {
        bodies.add(new Body.Sphere("ball", Vec3.ZERO, .5, 1, null, .6, 0));
        states.add(BodyState.resting(new Vec3(x, .5, 0)).moving(velocity, Vec3.ZERO));
        return this;
    }

    private RestJudgeTest cube(double x) {
        bodies.add(new Body.Box("cube", Vec3.ZERO, new Vec3(1, 1, 1), 1, null, .6, 0));
        states.add(BodyState.resting(new Vec3(x, .5, 0)).moving(ROLL, Vec3.ZERO));
        return this;
    }

    private RestJudgeTest capsule(Vec3 spin) {
        bodies.add(new Body.Capsule("capsule", Vec3.ZERO, .5, 2, 1, null, .6, 0));
        var lying = Rotations.aroundAxis(new Vec3(0, 0, 1), Math.PI / 2);
        states.add(new BodyState(new Vec3(0, .5, 0), lying, Vec3.ZERO, spin));
        return this;
    }

    private RestJudge judge() {
        BodyTable table = new BodyTable(bodies);
        return new RestJudge(table, new BodyDepth(table, WORLD));
    }

    /** All of them after a second, asleep. */
    private Bodies asleep() {
        RigidStep step = new RigidStep(new BodyTable(bodies), new Vec3(0, -9.81, 0));
        Bodies now = new BodyTable(bodies).start();
        for (int i = 0; i < states.size(); i++) {
            now = now.with(i, BodyState.resting(states.get(i).centre()));
        }
        for (int tick = 0; tick < 120; tick++) {
            now = step.step(now, Surroundings.of(WORLD), Influences.none(), 1 / 120.0);
        }
        return now;
    }

    private void rests(boolean expected) {
        assertEquals(expected, judge().isAtRest(Bodies.of(states)));
    }

    @Test
    void aBallRolls() {
        ball(0, ROLL).rests(true);
    }

    @Test
    void aBallFalls() {
        ball(0, new Vec3(0, -1, 0)).rests(false);
    }

    @Test
    void aCubeSlides() {
        cube(0).rests(false);
    }

    @Test
    void aBallMovesACube() {
        ball(0, ROLL).cube(1.002).rests(true);
    }

    @Test
    void aBallMovesACubeByAnother() {
        ball(0, ROLL).cube(2.003).cube(1.002).rests(true);
    }

    /** What sleeps passes no motion on. */
    @Test
    void aBallMovesNoCubeByASleepingOne() {
        ball(0, ROLL).cube(2.003).cube(1.002);
        Bodies now = asleep();
        Bodies woken = now.with(0, now.state(0).moving(ROLL, Vec3.ZERO))
                .with(1, now.state(1).moving(ROLL, Vec3.ZERO));
        assertTrue(woken.isAsleep(2));
        assertFalse(judge().isAtRest(woken));
        assertTrue(judge().isAtRest(now));
    }

    @Test
    void aBallMovesNoCubeFarOff() {
        ball(0, ROLL).cube(1.02).rests(false);
    }

    @Test
    void aBallThatStandsMovesNothing() {
        ball(0, Vec3.ZERO).cube(1.002).rests(false);
    }

    @Test
    void aCapsuleRollsAboutItsAxis() {
        capsule(new Vec3(3, 0, 0)).rests(true);
    }

    @Test
    void aCapsuleSpinsWhereItLies() {
        capsule(new Vec3(0, 3, 0)).rests(true);
    }

    @Test
    void aCapsuleTipsOver() {
        capsule(new Vec3(0, 0, 3)).rests(false);
    }
}
