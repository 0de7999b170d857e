package nephele.engine.cloud.field;

/**
 * The share of the sky that is meant to be covered.
 *
 * @param everywhere 0 to 1
 * @param map factor on it by place; {@code null} for none
 */
record Coverage(double everywhere, PlanMap map) {
    double at(double x, double z) {
        return map == null ? everywhere : everywhere * map.at(x, z);
    }

    boolean isNowhere() {
        return everywhere == 0 || map != null && map.isBlack();
    }

    /** Returns an upper bound in a rectangle, given by its centre and half its sides. */
    double greatest(double x, double z, double halfX, double halfZ) {
        return map == null ? everywhere : everywhere * map.greatest(x - halfX, z - halfZ, x + halfX, z + halfZ);
    }
}
