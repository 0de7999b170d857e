package nephele.engine.model.shape;

/**
 * Points of a unit circle at equal angles. Sine and cosine are exact at quarter turns, and the last point equals the
 * first. Results are the same on every machine, because physics depends on the last bit of a mesh.
 *
 * @param sine at i parts of the full turn, 0 to the number of parts
 * @param cosine likewise
 */
record Circle(double[] sine, double[] cosine) {
    static Circle of(int parts) {
        double[] sine = new double[parts + 1];
        double[] cosine = new double[parts + 1];
        for (int i = 0; i <= parts; i++) {
            sine[i] = sineOf(i, parts);
            cosine[i] = cosineOf(i, parts);
        }
        return new Circle(sine, cosine);
    }

    /**
     * Adds the flat end of a cone or a cylinder: a fan around its centre, with the image orientation of a box's face.
     *
     * @param side 1 for a face upwards, −1 for one downwards
     */
    void addDisc(MeshBuilder mesh, double radius, double y, int side) {
        int centre = mesh.point(0, y, 0).normal(0, side, 0).texture(0.5, 0.5);
        int slices = sine.length - 1;
        for (int i = 0; i < slices; i++) {
            double x = sine[i];
            double z = cosine[i];
            mesh.point(radius * x, y, radius * z).normal(0, side, 0).texture(0.5 + 0.5 * x, 0.5 - side * 0.5 * z);
        }
        for (int i = 0; i < slices; i++) {
            int here = centre + 1 + i;
            int next = centre + 1 + (i + 1) % slices;
            mesh.triangle(centre, side > 0 ? here : next, side > 0 ? next : here);
        }
    }

    /** Returns the cosine of {@code numerator / denominator} turns. */
    static double cosineOf(int numerator, int denominator) {
        return sineOf(4 * numerator + denominator, 4 * denominator);
    }

    /**
     * Returns the sine of {@code numerator / denominator} turns, folded into the first octant so that mirrored points
     * match.
     */
    static double sineOf(int numerator, int denominator) {
        int turn = Math.floorMod(numerator, denominator);
        if (2 * turn > denominator) {
            return -sineOf(denominator - turn, denominator);
        }
        int folded = Math.min(2 * turn, denominator - 2 * turn); // numerator in half turns; at most a quarter turn
        return 4 * folded <= denominator
                ? StrictMath.sin(Math.PI * folded / denominator)
                : StrictMath.cos(Math.PI * (denominator - 2 * folded) / (2.0 * denominator));
    }
}
