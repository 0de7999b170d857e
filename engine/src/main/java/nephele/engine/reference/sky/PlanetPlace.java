package nephele.engine.reference.sky;

import nephele.engine.atmosphere.Air;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/**
 * A place over the round planet, whose surface touches the plane y = 0 at the origin.
 *
 * @param altitudeMetres over its surface
 * @param zenith unit vector away from its centre
 */
record PlanetPlace(double altitudeMetres, Vec3 zenith) {
    private static final double PLANET = Air.PLANET_RADIUS_METRES;

    static PlanetPlace of(Vec3 place) {
        double up = PLANET + place.y();
        double across = place.x() * place.x() + place.z() * place.z();
        double distance = Math.sqrt(up * up + across);
        double altitude = up >= 0 ? place.y() + across / (distance + up) : distance - PLANET;
        return new PlanetPlace(altitude, new Vec3(place.x() / distance, up / distance, place.z() / distance));
    }

    /**
     * Returns how far a ray goes before the planet hides what follows: half its way through the planet, so that it still
     * meets what a level has below the ground, but nothing on the far side. Infinite if it misses the planet.
     *
     * @param ray of unit direction
     */
    static double reachMetres(Ray ray) {
        double up = PLANET + ray.originY();
        double along = ray.originX() * ray.directionX() + up * ray.directionY() + ray.originZ() * ray.directionZ();
        double squared = ray.originX() * ray.originX() + up * up + ray.originZ() * ray.originZ();
        return along < 0 && squared - along * along < PLANET * PLANET ? -along : Double.POSITIVE_INFINITY;
    }
}
