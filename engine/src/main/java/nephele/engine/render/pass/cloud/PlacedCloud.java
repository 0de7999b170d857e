package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudSource;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** A cloud of the level where it is at a time, usually that of the frame. */
public final class PlacedCloud {
    private final CloudSource source;
    private final int index;
    private double seconds;
    private Vec3 drift = Vec3.ZERO;
    private double presence;
    private double fractionDrawn = 1;

    /** @param index among the clouds of the level */
    PlacedCloud(CloudSource source, int index) {
        this.source = source;
        this.index = index;
    }

    /** Returns the same cloud, to be placed at other times. */
    public PlacedCloud again() {
        return new PlacedCloud(source, index);
    }

    public void follow(CloudInterval now) {
        seconds = now.seconds();
        drift = source.drift(seconds);
        presence = source.presence(seconds);
    }

    public CloudSource source() {
        return source;
    }

    public int index() {
        return index;
    }

    public double seconds() {
        return seconds;
    }

    /** Returns how far the wind has carried it. */
    public Vec3 drift() {
        return drift;
    }

    /** Returns the fraction of its extinction that its weather gives it, 0 if that is not there. */
    public double presence() {
        return presence;
    }

    /** Sets the fraction of its optical depth that is drawn, while another technique draws the rest. */
    void fractionDrawn(double fraction) {
        fractionDrawn = fraction;
    }

    /** Returns the fraction of its optical depth that is drawn, 0 to 1. */
    double fractionDrawn() {
        return fractionDrawn;
    }

    /** Returns the distance from a point to its bounds, metres; 0 inside. */
    public double distance(Vec3 from) {
        return bounds().nearest(from);
    }

    /** Returns its bounds at the time of the frame. */
    public Aabb bounds() {
        return source.bounds().moved(drift);
    }

    /** Returns its bounds at a time. */
    Aabb bounds(double at) {
        return source.bounds().moved(source.drift(at));
    }

    /** Returns how far the wind has carried it since another time. */
    Vec3 blown(double since) {
        return drift.minus(source.drift(since));
    }
}
