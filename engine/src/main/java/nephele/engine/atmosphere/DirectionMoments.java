package nephele.engine.atmosphere;

/**
 * Real spherical harmonics of functions that are symmetric to the plane through zenith and sun: those with cos(mφ), up to
 * a degree, normalised so that the squares integrate to 1 over the sphere. Recurrences: W. H. Press et al., "Numerical
 * Recipes", third edition, section 6.7.
 */
final class DirectionMoments {
    private static final double SQRT_2 = Math.sqrt(2);

    private final int degree;
    /** Factors of the recurrences in the degree, at the places of their results; and in the order. */
    private final double[] ofCosine;

    private final double[] ofBefore;
    private final double[] sectorial;

    /** @param degree the largest degree, l */
    DirectionMoments(int degree) {
        this.degree = degree;
        ofCosine = new double[count(degree)];
        ofBefore = new double[count(degree)];
        sectorial = new double[degree + 1];
        for (int m = 0; m <= degree; m++) {
            sectorial[m] = m == 0 ? Math.sqrt(1 / (4 * Math.PI)) : -Math.sqrt((2 * m + 1) / (2.0 * m));
            for (int l = m + 1; l <= degree; l++) {
                ofCosine[index(l, m)] = factor(l, m);
                ofBefore[index(l, m)] = l == m + 1 ? 0 : factor(l, m) / factor(l - 1, m);
            }
        }
    }

    private static double factor(int l, int m) {
        return Math.sqrt((4.0 * l * l - 1) / ((double) l * l - m * m));
    }

    /** Returns how many harmonics there are up to a degree. */
    static int count(int degree) {
        return (degree + 1) * (degree + 2) / 2;
    }

    /** Returns the place of a harmonic among all; those of a smaller degree come before it. */
    static int index(int l, int m) {
        return l * (l + 1) / 2 + m;
    }

    /**
     * Puts the values of all harmonics.
     *
     * @param cosine of the angle to the zenith
     * @param azimuthCosine of the azimuth from the sun
     */
    void put(double cosine, double azimuthCosine, double[] values) {
        put(cosine, azimuthCosine, degree, values);
    }

    /** Puts the values of the harmonics up to a degree. */
    void put(double cosine, double azimuthCosine, int upTo, double[] values) {
        double sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
        double first = sectorial[0];
        double cosM = 1;
        double cosBefore = azimuthCosine;
        for (int m = 0; m <= upTo; m++) {
            if (m > 0) {
                first *= sine * sectorial[m];
                double next = 2 * azimuthCosine * cosM - cosBefore;
                cosBefore = cosM;
                cosM = next;
            }
            putOrder(m, upTo, cosine, first, (m == 0 ? 1 : SQRT_2) * cosM, values);
        }
    }

    private void putOrder(int m, int upTo, double cosine, double first, double factor, double[] values) {
        double before = 0;
        double now = first;
        for (int l = m; l <= upTo; l++) {
            int at = index(l, m);
            if (l > m) {
                double next = ofCosine[at] * cosine * now - ofBefore[at] * before;
                before = now;
                now = next;
            }
            values[at] = factor * now;
        }
    }
}
