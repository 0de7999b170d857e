package nephele.engine.cloud.cells;

import nephele.engine.cloud.DeltaScaling;
import nephele.engine.math.Vec3;

/**
 * The fluence of diffuse sunlight in a finite cloud: the diffusion approximation in three dimensions (Ishimaru 1978, "Wave
 * Propagation and Scattering in Random Media", chapter 9). With the scaled extinction σ, albedo ω, mean cosine g and the beam's
 * irradiance E,
 *
 * <pre>
 * −∇·(D ∇φ) + (1 − ω) σ φ = ω (1 − ωg + g)/(1 − ωg) σ E,   D = 1 / (3 σ (1 − ωg))
 * </pre>
 *
 * <p>on cells of finite volume, solved by conjugate gradients (Hestenes and Stiefel 1952) with the diagonal as preconditioner.
 * Light that leaves the box does not come back: its net flux there is φ/2 (Marshak 1947). The flow ωg/(1 − ωg) E along the
 * beam through lit faces, which that condition should hold too, is left out: with it clouds that are marched through this
 * light were 10 to 40 % too dark, as Eddington's light is near lit sides, and without it within 10 %.
 *
 * <p>Clear air is a medium that conducts light over a fifth of the box's least edge and takes it away, so that a face of the
 * cloud meets the same φ/2, and faces that are close together light each other. Not for several threads.
 */
final class DiffusionGrid {
    /** How far clear air conducts light, divided by the least edge of the box. */
    private static final double CLEAR_REACH = 0.2;
    /** A fraction of the greatest extinction; where there is less, air is clear to a degree. */
    private static final double CLEAR_BELOW = 0.01;
    /** Greatest D divided by the least edge of the box: in thin parts light goes straight. */
    private static final double GREATEST = 1;

    private static final double TOLERANCE = 1e-3;
    private static final int MOST_ROUNDS = 400;

    private final int[] counts;
    private final int[] strides;
    private final double[] edges;
    private final double[][] links = new double[3][];
    private final double[] diagonal;
    private final double[] source;

    private final double[] fluence;

    /**
     * Sets up the equations.
     *
     * @param perMetre mean extinction of the cells
     * @param sunDepths optical depths towards the sun from their centres, every {@code stride} numbers
     * @param towardsSun unit
     * @param fluence a guess, per unit irradiance
     */
    DiffusionGrid(
            CellBox cells,
            float[] perMetre,
            float[] sunDepths,
            int stride,
            DeltaScaling medium,
            Vec3 towardsSun,
            double[] fluence) {
        this.fluence = fluence;
        counts = new int[] {cells.nx(), cells.ny(), cells.nz()};
        strides = new int[] {1, cells.nx(), cells.nx() * cells.ny()};
        edges = new double[] {cells.sizeX(), cells.sizeY(), cells.sizeZ()};
        diagonal = new double[cells.count()];
        source = new double[cells.count()];
        putSource(perMetre, sunDepths, stride, medium, towardsSun);
        link(putMedium(perMetre, clear(perMetre), medium));
    }

    private double volume() {
        return edges[0] * edges[1] * edges[2];
    }

    private void putSource(float[] perMetre, float[] sunDepths, int stride, DeltaScaling medium, Vec3 sun) {
        double scale = medium.depthFactor();
        double turned = medium.albedo() * medium.g();
        double gain = medium.albedo() * (1 - turned + medium.g()) / (1 - turned);
        double perEdge = Math.abs(sun.x()) / edges[0] + Math.abs(sun.y()) / edges[1] + Math.abs(sun.z()) / edges[2];
        for (int i = 0; i < source.length; i++) {
            double within = scale * perMetre[i] / perEdge;
            double first = Math.max(0, scale * sunDepths[stride * i] - within / 2);
            source[i] = volume() * gain * perEdge * Math.exp(-first) * -Math.expm1(-within);
        }
    }

    private static double[] clear(float[] perMetre) {
        double below = 1e-30;
        for (float extinction : perMetre) {
            below = Math.max(below, CLEAR_BELOW * extinction);
        }
        double[] clear = new double[perMetre.length];
        for (int i = 0; i < clear.length; i++) {
            clear[i] = Math.max(0, 1 - perMetre[i] / below);
        }
        return clear;
    }

    /** Puts what cells take away and returns their D. */
    private double[] putMedium(float[] perMetre, double[] clear, DeltaScaling medium) {
        double least = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            least = Math.min(least, counts[axis] * edges[axis]);
        }
        double edge = Math.cbrt(volume());
        double clearD = Math.max(edge, CLEAR_REACH * least) / 2;
        // A row of clear cells takes as much as Marshak's condition, seen from the side of its first cell.
        double admittance = 1 / (2 - edge / (2 * clearD));
        double clearSink = admittance * admittance / (clearD / edge + admittance) / edge;
        double[] conductivity = new double[perMetre.length];
        for (int i = 0; i < perMetre.length; i++) {
            double extinction = medium.depthFactor() * perMetre[i];
            double straightened = 3 * extinction * (1 - medium.albedo() * medium.g());
            conductivity[i] = 1 / (straightened + clear[i] / clearD + (1 - clear[i]) / (GREATEST * least));
            diagonal[i] = volume() * (extinction * (1 - medium.albedo()) + clear[i] * clearSink);
        }
        return conductivity;
    }

    /** Links each cell with the next ones along the axes, and the outer ones with the outside. */
    private void link(double[] conductivity) {
        for (int axis = 0; axis < 3; axis++) {
            double area = volume() / edges[axis];
            double half = edges[axis] / 2;
            links[axis] = new double[diagonal.length];
            for (int i = 0; i < diagonal.length; i++) {
                int at = i / strides[axis] % counts[axis];
                double outside = area / (2 + half / conductivity[i]);
                diagonal[i] += at == 0 ? outside : 0;
                if (at == counts[axis] - 1) {
                    diagonal[i] += outside;
                } else {
                    int next = i + strides[axis];
                    double link = area / (half / conductivity[i] + half / conductivity[next]);
                    links[axis][i] = link;
                    diagonal[i] += link;
                    diagonal[next] += link;
                }
            }
        }
    }

    /** Solves the equations in the fluence that was given, to a thousandth, and returns it. */
    double[] solve() {
        int n = fluence.length;
        double[] residual = new double[n];
        double[] towards = new double[n];
        double[] product = new double[n];
        multiply(fluence, product);
        double whole = 0;
        double left = 0;
        for (int i = 0; i < n; i++) {
            residual[i] = source[i] - product[i];
            towards[i] = residual[i] / diagonal[i];
            left += residual[i] * towards[i];
            whole += source[i] * source[i] / diagonal[i];
        }
        for (int round = 0; round < MOST_ROUNDS && left > TOLERANCE * TOLERANCE * whole; round++) {
            multiply(towards, product);
            double step = left / dot(towards, product);
            double before = left;
            left = 0;
            for (int i = 0; i < n; i++) {
                fluence[i] += step * towards[i];
                residual[i] -= step * product[i];
                left += residual[i] * residual[i] / diagonal[i];
            }
            for (int i = 0; i < n; i++) {
                towards[i] = residual[i] / diagonal[i] + left / before * towards[i];
            }
        }
        return fluence;
    }

    private void multiply(double[] in, double[] out) {
        for (int i = 0; i < in.length; i++) {
            out[i] = diagonal[i] * in[i];
        }
        for (int axis = 0; axis < 3; axis++) {
            int stride = strides[axis];
            double[] link = links[axis];
            for (int i = 0; i + stride < in.length; i++) {
                out[i] -= link[i] * in[i + stride];
                out[i + stride] -= link[i] * in[i];
            }
        }
    }

    private static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    /** Returns −∂φ/∂a at a cell along a direction a, per metre, from the cells on both sides. */
    double fall(int cell, Vec3 along) {
        return -along.x() * slope(cell, 0) - along.y() * slope(cell, 1) - along.z() * slope(cell, 2);
    }

    private double slope(int cell, int axis) {
        int at = cell / strides[axis] % counts[axis];
        int low = at > 0 ? cell - strides[axis] : cell;
        int high = at < counts[axis] - 1 ? cell + strides[axis] : cell;
        return low == high ? 0 : (fluence[high] - fluence[low]) * strides[axis] / ((high - low) * edges[axis]);
    }
}
