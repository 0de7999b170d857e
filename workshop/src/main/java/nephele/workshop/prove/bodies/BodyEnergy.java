package nephele.workshop.prove.bodies;

import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.level.Body;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The mechanical energy of bodies, from the textbook formulas of the moments of inertia. It shares no code with the
 * solver.
 */
final class BodyEnergy {
    private final Vector3d v = new Vector3d();
    private final Quaterniond worldFromBody = new Quaterniond();

    /** Returns the energy of translation and rotation, in joules. */
    double kinetic(Body body, Bodies bodies, int index) {
        double joules = body.massKilograms() / 2 * bodies.velocity(index, v).lengthSquared();
        bodies.orientation(index, worldFromBody).transformInverse(bodies.spin(index, v));
        return joules + rotational(body, v);
    }

    /** @param spin in the body's axes, rad/s */
    private static double rotational(Body body, Vector3d spin) {
        double m = body.massKilograms();
        if (body instanceof Body.Box box) {
            double x = box.size().x() * box.size().x();
            double y = box.size().y() * box.size().y();
            double z = box.size().z() * box.size().z();
            return m / 24 * ((y + z) * spin.x * spin.x + (x + z) * spin.y * spin.y + (x + y) * spin.z * spin.z);
        }
        if (body instanceof Body.Sphere ball) {
            return m / 5 * ball.radiusMetres() * ball.radiusMetres() * spin.lengthSquared();
        }
        return rotational((Body.Capsule) body, spin);
    }

    /** Uses a cylinder of length h and two half balls of radius r with centres of mass 3 r / 8 beyond its ends. */
    private static double rotational(Body.Capsule capsule, Vector3d spin) {
        double r = capsule.radiusMetres();
        double h = Math.max(0, capsule.heightMetres() - 2 * r);
        double volume = h + 4 * r / 3;
        double tube = capsule.massKilograms() * h / volume;
        double caps = capsule.massKilograms() - tube;
        double along = tube * r * r / 2 + caps * 2 * r * r / 5;
        double capCentre = h / 2 + 3 * r / 8;
        double capAcross = 83 * r * r / 320 + capCentre * capCentre;
        double across = tube * (3 * r * r + h * h) / 12 + caps * capAcross;
        return (along * spin.y * spin.y + across * (spin.x * spin.x + spin.z * spin.z)) / 2;
    }
}
