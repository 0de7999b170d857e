package nephele.engine.atmosphere;

import java.util.Arrays;
import nephele.engine.math.GaussLegendre;

/**
 * Integrates light along rays by Gauss–Legendre quadrature on each piece of a ray; the optical depth up to a node is the
 * integral of the polynomial through the nodes. Not for several threads.
 */
final class AirIntegral {
    /** The quadrature for reference values. */
    static final GaussLegendre FINE = new GaussLegendre(10);
    /** The quadrature for rays that are cut into short pieces. */
    static final GaussLegendre SHORT = new GaussLegendre(3);
    /** The quadrature for light that is scattered often, where speed counts. */
    static final GaussLegendre SHORTEST = new GaussLegendre(2);
    /** The quadrature for light that is smooth along the ray. */
    static final GaussLegendre COARSE = new GaussLegendre(5);

    private static final int CHANNELS = Air.CHANNELS;
    private static final int MOST_COLOURS = 3;

    private final Air air;
    private final GaussLegendre rule;
    private final double[] extinction = new double[CHANNELS];
    private final double[][] extinctions;
    private final double[][] sources;
    private final double[] depthBefore = new double[CHANNELS];

    AirIntegral(Air air, GaussLegendre rule) {
        this.air = air;
        this.rule = rule;
        extinctions = new double[rule.nodes.length][CHANNELS];
        sources = new double[rule.nodes.length][MOST_COLOURS * CHANNELS];
    }

    /** Puts the optical depth of the whole ray. */
    void putDepth(AirRay ray, double[] depth) {
        Arrays.fill(depth, 0);
        for (int piece = 0; piece < ray.pieceCount(); piece++) {
            double from = ray.cut(piece);
            double length = ray.cut(piece + 1) - from;
            for (int k = 0; k < rule.nodes.length; k++) {
                ray.lookAt(from + length * rule.nodes[k]);
                ray.putExtinctionPerMetre(air, extinction);
                for (int c = 0; c < CHANNELS; c++) {
                    depth[c] += length * rule.weights[k] * extinction[c];
                }
            }
        }
    }

    /**
     * Puts the light that reaches the origin of the ray.
     *
     * @param radiance colour by colour
     * @param transmittance of the whole ray, for each wavelength
     */
    void put(AirRay ray, AirSource source, double[] radiance, double[] transmittance) {
        int values = source.colours() * CHANNELS;
        Arrays.fill(radiance, 0, values, 0);
        Arrays.fill(depthBefore, 0);
        for (int piece = 0; piece < ray.pieceCount(); piece++) {
            double from = ray.cut(piece);
            double length = ray.cut(piece + 1) - from;
            if (length > 0) {
                evaluate(ray, source, from, length);
                addPiece(length, values, radiance);
            }
        }
        for (int c = 0; c < CHANNELS; c++) {
            transmittance[c] = Math.exp(-depthBefore[c]);
        }
    }

    /**
     * Puts the light of one colour that parts of a segment of increasing length send to its origin, and the
     * transmittance of these parts.
     *
     * @param distances ends of the parts, at which the segment is cut
     * @param light for each part radiance, then transmittance, each for every wavelength
     */
    void putParts(AirRay segment, AirSource source, double[] distances, double[] light) {
        double[] radiance = new double[CHANNELS];
        Arrays.fill(depthBefore, 0);
        int part = 0;
        for (int piece = 0; piece < segment.pieceCount(); piece++) {
            double from = segment.cut(piece);
            for (; part < distances.length && distances[part] <= from; part++) {
                putPart(part, radiance, light);
            }
            double length = segment.cut(piece + 1) - from;
            if (length > 0) {
                evaluate(segment, source, from, length);
                addPiece(length, CHANNELS, radiance);
            }
        }
        for (; part < distances.length; part++) {
            putPart(part, radiance, light);
        }
    }

    private void putPart(int part, double[] radiance, double[] light) {
        for (int c = 0; c < CHANNELS; c++) {
            light[2 * CHANNELS * part + c] = radiance[c];
            light[2 * CHANNELS * part + CHANNELS + c] = Math.exp(-depthBefore[c]);
        }
    }

    private void evaluate(AirRay ray, AirSource source, double from, double length) {
        for (int k = 0; k < rule.nodes.length; k++) {
            ray.lookAt(from + length * rule.nodes[k]);
            ray.putExtinctionPerMetre(air, extinctions[k]);
            source.put(ray, sources[k]);
        }
    }

    private void addPiece(double length, int values, double[] radiance) {
        int count = rule.nodes.length;
        for (int c = 0; c < CHANNELS; c++) {
            double whole = 0;
            for (int j = 0; j < count; j++) {
                double depth = 0;
                double[] row = rule.upTo[j];
                for (int k = 0; k < count; k++) {
                    depth += row[k] * extinctions[k][c];
                }
                double weight = length * rule.weights[j] * Math.exp(-depthBefore[c] - length * depth);
                for (int value = c; value < values; value += CHANNELS) {
                    radiance[value] += weight * sources[j][value];
                }
                whole += rule.weights[j] * extinctions[j][c];
            }
            depthBefore[c] += length * whole;
        }
    }
}
