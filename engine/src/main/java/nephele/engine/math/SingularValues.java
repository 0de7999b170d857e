package nephele.engine.math;

import org.joml.Matrix4dc;

/** Computes the maximum stretch of a matrix. */
public final class SingularValues {
    private static final int MOST_SWEEPS = 12;

    private SingularValues() {}

    /**
     * Returns the largest singular value of the linear part, the tight bound of the growth of a sphere's radius. It is
     * the root of the largest eigenvalue of mᵀ·m by Jacobi rotations (Jacobi 1846), which lose no digits for multiple
     * eigenvalues. Allocates nothing; NaN if the matrix is not finite.
     */
    public static double maximum(Matrix4dc m) {
        double scale = largestEntry(m);
        if (!(scale > 0 && scale <= Double.MAX_VALUE)) {
            return scale == 0 ? 0 : Double.NaN;
        }
        // Scaling prevents overflow and underflow of squares; division, because the inverse of a tiny scale is
        // infinite.
        double x0 = m.m00() / scale;
        double x1 = m.m01() / scale;
        double x2 = m.m02() / scale;
        double y0 = m.m10() / scale;
        double y1 = m.m11() / scale;
        double y2 = m.m12() / scale;
        double z0 = m.m20() / scale;
        double z1 = m.m21() / scale;
        double z2 = m.m22() / scale;
        double eigenvalue = largestEigenvalue(
                x0 * x0 + x1 * x1 + x2 * x2,
                y0 * y0 + y1 * y1 + y2 * y2,
                z0 * z0 + z1 * z1 + z2 * z2,
                x0 * y0 + x1 * y1 + x2 * y2,
                x0 * z0 + x1 * z1 + x2 * z2,
                y0 * z0 + y1 * z1 + y2 * z2);
        return scale * Math.sqrt(eigenvalue);
    }

    private static double largestEntry(Matrix4dc m) {
        double x = Math.max(Math.abs(m.m00()), Math.max(Math.abs(m.m01()), Math.abs(m.m02())));
        double y = Math.max(Math.abs(m.m10()), Math.max(Math.abs(m.m11()), Math.abs(m.m12())));
        double z = Math.max(Math.abs(m.m20()), Math.max(Math.abs(m.m21()), Math.abs(m.m22())));
        return Math.max(x, Math.max(y, z));
    }

    /**
     * Returns the largest eigenvalue of the symmetric matrix with diagonal a, b, c and d = (a, b), e = (a, c), f = (b,
     * c).
     */
    private static double largestEigenvalue(
            double startA, double startB, double startC, double startD, double startE, double startF) {
        double a = startA;
        double b = startB;
        double c = startC;
        double d = startD;
        double e = startE;
        double f = startF;
        for (int sweep = 0; sweep < MOST_SWEEPS && !(d == 0 && e == 0 && f == 0); sweep++) {
            double t = tangent(a, b, d);
            double cos = 1 / Math.sqrt(1 + t * t);
            double sin = t * cos;
            a -= t * d;
            b += t * d;
            d = 0;
            double e1 = cos * e - sin * f;
            f = sin * e + cos * f;
            e = e1;

            t = tangent(a, c, e);
            cos = 1 / Math.sqrt(1 + t * t);
            sin = t * cos;
            a -= t * e;
            c += t * e;
            e = 0;
            d = -sin * f;
            f = cos * f;

            t = tangent(b, c, f);
            cos = 1 / Math.sqrt(1 + t * t);
            sin = t * cos;
            b -= t * f;
            c += t * f;
            f = 0;
            e = sin * d;
            d = cos * d;
        }
        return Math.max(a, Math.max(b, c));
    }

    /** Returns the tangent of the smaller Jacobi angle that makes the common entry of p and q vanish. */
    private static double tangent(double p, double q, double common) {
        if (common == 0) {
            return 0;
        }
        double cotangent = (q - p) / (2 * common);
        return Math.copySign(1, cotangent) / (Math.abs(cotangent) + Math.sqrt(1 + cotangent * cotangent));
    }
}
