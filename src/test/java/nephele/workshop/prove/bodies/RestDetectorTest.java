package nephele.workshop.prove.bodies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Awake bodies are accepted only if they roll, spin or are moved by one that does. */
class RestDetectorTest {
    private static final CollisionWorld WORLD = BoxPile.closedRoom(6, 6, 1);
    private static final Vec3 ROLL = new Vec3(1, 0, 0);

    private final List<Body> bodies = new ArrayList<>();
    private final List<BodyState> states = new ArrayList<>();

    private RestDetectorTest ball(Vec3 centre, Vec3 velocity, Vec3 spin) {
        bodies.add(new Body.Sphere("ball", Vec3.ZERO, .5, 1, null, .6, 0));
        states.add(BodyState.resting(centre).moving(velocity, spin));
        return this;
    }

    private RestDetectorTest rollingBall() {
        return ball(new Vec3(0, .5, 0), ROLL, new Vec3(0, 0, -2));
    }

    private RestDetectorTest cube(double x) {
        bodies.add(new Body.Box("cube", Vec3.ZERO, new Vec3(1, 1, 1), 1, null, .6, 0));
        states.add(BodyState.resting(new Vec3(x, .5, 0)).moving(ROLL, Vec3.ZERO));
        return this;
    }

    /** Adds a capsule of 2 m by 1 m along x, with its western end on the floor. */
    private RestDetectorTest capsule(double risingRadians, Vec3 velocity, Vec3 spin) {
        bodies.add(new Body.Capsule("capsule", Vec3.ZERO, .5, 2, 1, null, .6, 0));
        var turn = Rotations.aroundAxis(new Vec3(0, 0, 1), risingRadians - Math.PI / 2);
        states.add(new BodyState(new Vec3(0, .5 + .5 * Math.sin(risingRadians), 0), turn, velocity, spin));
        return this;
    }

    /** Observes these states in turn and judges the last. */
    private boolean isAtRest(Bodies... seen) {
        RestDetector judge = new RestDetector(new BodyTable(bodies), WORLD);
        for (Bodies one : seen) {
            judge.observe(one);
        }
        return judge.isAtRest(seen[seen.length - 1]);
    }

    /** Returns the bodies after a second, asleep. */
    private Bodies asleep() {
        RigidStep step = new RigidStep(new BodyTable(bodies), new Vec3(0, -9.81, 0));
        Bodies now = new BodyTable(bodies).start();
        for (int i = 0; i < states.size(); i++) {
            now = now.with(i, BodyState.resting(states.get(i).centre()));
        }
        for (int tick = 0; tick < 120; tick++) {
            now = step.step(now, PortalWorld.of(WORLD), BodyInfluences.none(), 1 / 120.0);
        }
        return now;
    }

    private void rests(boolean expected) {
        assertEquals(expected, isAtRest(Bodies.of(states)));
    }

    @Test
    void aBallRolls() {
        rollingBall().rests(true);
    }

    @Test
    void aBallSlides() {
        ball(new Vec3(0, .5, 0), ROLL, Vec3.ZERO).rests(false);
    }

    @Test
    void aBallHangs() {
        ball(new Vec3(0, .506, 0), Vec3.ZERO, Vec3.ZERO).rests(false);
    }

    /** The upper ball slips on the lower one, which moves it. */
    @Test
    void aBallMovesOneOnTop() {
        rollingBall().ball(new Vec3(0, 1.5, 0), ROLL, Vec3.ZERO).rests(true);
    }

    @Test
    void aCubeSlides() {
        cube(0).rests(false);
    }

    @Test
    void aBallMovesACube() {
        rollingBall().cube(1.002).rests(true);
    }

    @Test
    void aBallMovesACubeByAnother() {
        rollingBall().cube(2.003).cube(1.002).rests(true);
    }

    /** A sleeping body transmits no motion. */
    @Test
    void aBallMovesNoCubeByASleepingOne() {
        rollingBall().cube(2.003).cube(1.002);
        Bodies now = asleep();
        Bodies woken = now.with(0, now.state(0).moving(ROLL, new Vec3(0, 0, -2)))
                .with(1, now.state(1).moving(ROLL, Vec3.ZERO));
        assertTrue(woken.isAsleep(2));
        assertFalse(isAtRest(woken));
        assertTrue(isAtRest(now));
    }

    @Test
    void aBallMovesNoCubeFarOff() {
        rollingBall().cube(1.02).rests(false);
    }

    @Test
    void aBallThatStandsMovesNothing() {
        ball(new Vec3(0, .5, 0), Vec3.ZERO, Vec3.ZERO).cube(1.002).rests(false);
    }

    /** The cube falls asleep half a second after the ball has gone. */
    @Test
    void aBallHasMovedACubeAndGoneOn() {
        rollingBall().cube(1.002);
        Bodies touching = Bodies.of(states);
        Bodies gone = touching.with(
                0, new BodyState(new Vec3(-1, .5, 0), touching.state(0).orientation(), ROLL, Vec3.ZERO));
        assertTrue(isAtRest(touching, gone));
        assertFalse(isAtRest(gone));
    }

    @Test
    void aCapsuleRollsAboutItsAxis() {
        capsule(0, new Vec3(0, 0, -1), new Vec3(-2, 0, 0)).rests(true);
    }

    @Test
    void aCapsuleSpinsWhereItLies() {
        capsule(0, Vec3.ZERO, new Vec3(0, 3, 0)).rests(true);
    }

    @Test
    void aCapsuleSpinsAboutItsAxisAndSlips() {
        capsule(0, Vec3.ZERO, new Vec3(3, 0, 0)).rests(false);
    }

    /** Its lower end rolls, regardless of the other end's motion. */
    @Test
    void aCapsuleRocksOnItsEnd() {
        Vec3 spin = new Vec3(0, 0, 2);
        capsule(.3, new Vec3(-2 * (.5 + .5 * Math.sin(.3)), 2 * .5 * Math.cos(.3), 0), spin)
                .rests(true);
    }
}
