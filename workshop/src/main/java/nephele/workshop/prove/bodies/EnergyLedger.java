package nephele.workshop.prove.bodies;

import nephele.engine.collision.rigid.body.Bodies;
import nephele.engine.collision.rigid.body.BodyTable;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.Portals;
import nephele.engine.sim.state.PlayerDimensions;
import org.joml.Vector3d;

/**
 * The mechanical energy of bodies, tick by tick: kinetic energy and m g height. Each time a centre passes through a
 * portal, the change of its height by the portal transform is recorded, and the body's height is measured from a
 * reference moved by as much.
 */
public final class EnergyLedger {
    /** A body that ends the tick this near to the end of its arc is assumed to have moved along it. */
    private static final double ON_ARC_METRES = 1e-9;

    private final BodyTable table;
    private final Portals portals;
    private final double seconds;
    /** The sum of the recorded changes of height of each body, in metres. */
    private final double[] booked;

    private final BodyEnergy energy = new BodyEnergy();
    private final PortalCrossing crossing = new PortalCrossing();
    private final Vector3d place = new Vector3d();
    private final Vector3d velocity = new Vector3d();
    private final Vector3d pull = new Vector3d();
    private final Vector3d end = new Vector3d();
    private long crossings;

    public EnergyLedger(BodyTable table, Portals portals, double seconds) {
        this.table = table;
        this.portals = portals;
        this.seconds = seconds;
        booked = new double[table.size()];
    }

    /** Returns the energy of all bodies in joules; height 0 is the floor. */
    public double joules(Bodies bodies) {
        double sum = 0;
        for (int i = 0; i < bodies.size(); i++) {
            double height = bodies.centre(i, place).y - booked[i];
            sum += energy.kinetic(table.body(i), bodies, i)
                    + table.massKilograms(i) * PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED * height;
        }
        return sum;
    }

    /** Returns the number of passages of centres through portals so far. */
    long crossings() {
        return crossings;
    }

    /** Records the passages of one tick. */
    void book(Bodies before, Bodies after) {
        for (int i = 0; i < after.size(); i++) {
            if (after.crossings(i) > 0) {
                crossings += after.crossings(i);
                booked[i] += changeOfHeight(before, after, i);
            }
        }
    }

    /**
     * Returns the change of height by the passages of a tick. The solver moves a body along its arc if it has no
     * contact, and along a straight line otherwise.
     */
    private double changeOfHeight(Bodies before, Bodies after, int body) {
        before.centre(body, place);
        before.velocity(body, velocity);
        double onArc = along(after, body, pull.set(0, -PlayerDimensions.GRAVITY_METRES_PER_SECOND_SQUARED, 0), seconds);
        if (place.distance(after.centre(body, end)) < ON_ARC_METRES) {
            return onArc;
        }
        unfolded(after, body).sub(before.centre(body, place), velocity);
        return along(after, body, pull.zero(), 1);
    }

    /**
     * Returns the sum of the changes of height by the passages on the path from {@link #place} with the velocity
     * {@link #velocity}; place becomes the path's end. A passage that rounding moves beyond the path counts at its end.
     */
    private double along(Bodies after, int body, Vector3d acceleration, double duration) {
        double change = 0;
        double left = duration;
        for (int i = 0; i < after.crossings(body); i++) {
            boolean found = crossing.find(portals, place, velocity, acceleration, left)
                    && crossing.portal() == after.crossing(body, i);
            double t = found ? crossing.seconds() : left;
            advance(t, acceleration);
            left -= t;
            change -= place.y;
            portals.transform(after.crossing(body, i)).point(place);
            portals.transform(after.crossing(body, i)).direction(velocity);
            change += place.y;
        }
        advance(left, acceleration);
        return change;
    }

    private void advance(double t, Vector3d acceleration) {
        place.fma(t, velocity).fma(t * t / 2, acceleration);
        velocity.fma(t, acceleration);
    }

    /** Returns the centre in the continuation of the first space beyond the portals. */
    private Vector3d unfolded(Bodies after, int body) {
        after.centre(body, end);
        for (int i = after.crossings(body) - 1; i >= 0; i--) {
            portals.transform(portals.partner(after.crossing(body, i))).point(end);
        }
        return end;
    }
}
