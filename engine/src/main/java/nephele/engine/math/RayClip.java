package nephele.engine.math;

/** The part of a ray that is behind planes, found by clipping (Cyrus and Beck 1978). */
public final class RayClip {
    private final Ray ray;
    private double enter;
    private double leave;

    /** Starts with the part between two ray parameters, which can be infinite. */
    public RayClip(Ray ray, double enter, double leave) {
        this.ray = ray;
        this.enter = enter;
        this.leave = leave;
    }

    /** Cuts off what is in front of a plane. */
    public void keepBehind(Plane plane) {
        keepBehind(rate(plane), front(plane));
    }

    /** Cuts off what is behind a plane. */
    public void keepInFront(Plane plane) {
        keepBehind(-rate(plane), -front(plane));
    }

    /**
     * Cuts off what is in front of a plane; a ray that runs along it is kept if it begins on it or behind.
     *
     * @param rate change of the signed distance in metres for each unit of the ray parameter
     * @param front signed distance of the ray's origin in metres
     */
    public void keepBehind(double rate, double front) {
        if (rate < 0) {
            enter = Math.max(enter, -front / rate);
        } else if (rate > 0) {
            leave = Math.min(leave, -front / rate);
        } else if (front > 0) {
            leave = Double.NEGATIVE_INFINITY;
        }
    }

    private double rate(Plane plane) {
        return plane.nx() * ray.directionX() + plane.ny() * ray.directionY() + plane.nz() * ray.directionZ();
    }

    private double front(Plane plane) {
        return plane.signedDistance(ray.originX(), ray.originY(), ray.originZ());
    }

    /** Returns the ray parameter at which the rest begins. */
    public double enter() {
        return enter;
    }

    /** Returns the ray parameter at which the rest ends, less than {@link #enter} if nothing is left. */
    public double leave() {
        return leave;
    }
}
