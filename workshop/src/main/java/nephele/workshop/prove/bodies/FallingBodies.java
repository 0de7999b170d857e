package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.PortalWorld;
import nephele.engine.collision.rigid.RigidStep;
import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyInfluences;
import nephele.engine.collision.rigid.body.BodyState;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.level.Body;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/** Bodies of the solver that fall from floor to floor through a pair of portals, each alone. */
final class FallingBodies {
    private static final Vec3 GRAVITY = new Vec3(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0);
    private static final Vec3 SPIN = new Vec3(1, 2, 3);
    private static final Vec3 CUBE = new Vec3(0.4, 0.4, 0.4);

    private final PortalWorld portalWorld;

    FallingBodies(PortalWorld portalWorld) {
        this.portalWorld = portalWorld;
    }

    /** Drops each body {@code falls} times at {@code rate} ticks a second. */
    ProofResult run(int rate, long falls) {
        Vec3 middle = portalWorld.portals().portal(0).centre();
        Vec3 from = new Vec3(middle.x(), middle.y() + FallsProof.HEIGHT_METRES, middle.z());
        List<Body> bodies = List.of(
                new Body.Box("cube", from, CUBE, 1, null, 0.6, 0),
                new Body.Sphere("ball", from, 0.3, 1, null, 0.6, 0),
                new Body.Capsule("capsule", from, 0.2, 0.7, 1, null, 0.6, 0));
        ProofResult result = ProofResult.NOTHING;
        for (Body body : bodies) {
            result = result.and(falls(body, rate, falls));
        }
        return result;
    }

    private ProofResult falls(Body body, int rate, long falls) {
        RigidStep step = new RigidStep(new BodyTable(List.of(body)), GRAVITY);
        Vec3 spin = body instanceof Body.Capsule ? Vec3.ZERO : SPIN;
        Bodies bodies = Bodies.of(List.of(BodyState.resting(body.centre()).moving(Vec3.ZERO, spin)));
        PortalWorld surroundings = portalWorld;
        double worst = 0;
        long passes = 0;
        long idleTicks = 0;
        while (passes < falls && idleTicks < 10L * rate) {
            bodies = step.step(bodies, surroundings, BodyInfluences.none(), 1.0 / rate);
            idleTicks = bodies.crossings(0) > 0 ? 0 : idleTicks + 1;
            passes += bodies.crossings(0);
            worst = Math.max(worst, Math.abs(apex(bodies) - FallsProof.HEIGHT_METRES));
        }
        List<String> failures = new ArrayList<>();
        if (!(worst <= FallsProof.BAR_METRES) || passes < falls) {
            failures.add("at " + rate + " ticks a second, after " + passes + " falls: " + body + " is off by " + worst
                    + " m");
        }
        return ProofResult.of(
                0,
                failures,
                Figure.sum("falls of a " + body.id(), passes, ""),
                Figure.greatest("apex of a " + body.id() + " off 2 m", worst, "m"));
    }

    /** Returns the height of the apex of the centre's arc, h + v² / 2 g, in metres. */
    private static double apex(Bodies bodies) {
        double v = bodies.velocity(0, new Vector3d()).y;
        return bodies.centre(0, new Vector3d()).y + v * v / (2 * PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED);
    }
}
