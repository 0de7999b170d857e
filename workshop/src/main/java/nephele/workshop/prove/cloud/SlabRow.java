package nephele.workshop.prove.cloud;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/**
 * The fluxes of a homogeneous slab with Henyey-Greenstein phase function, as fractions of the incident flux. Computed by
 * adding-doubling and rounded to 1e-6.
 *
 * @param depth optical depth along the normal
 * @param mu0 cosine of the angle between beam and normal
 * @param reflected of a parallel beam
 * @param transmitted of a parallel beam, with what is not scattered
 * @param diffuseReflected of isotropic incident radiance
 * @param diffuseTransmitted likewise
 */
record SlabRow(
        double albedo,
        double g,
        double depth,
        double mu0,
        double reflected,
        double transmitted,
        double diffuseReflected,
        double diffuseTransmitted) {
    private static final String FILE = "slab_truth.csv";

    /** Reads all rows of the table. */
    static List<SlabRow> all() {
        try (var in = SlabRow.class.getResourceAsStream(FILE);
                var lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.US_ASCII))) {
            return lines.lines().skip(1).map(SlabRow::parsed).toList();
        } catch (IOException problem) {
            throw new UncheckedIOException(FILE, problem);
        }
    }

    private static SlabRow parsed(String line) {
        double[] n =
                Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray();
        return new SlabRow(n[0], n[1], n[2], n[3], n[4], n[5], n[7], n[8]);
    }
}
