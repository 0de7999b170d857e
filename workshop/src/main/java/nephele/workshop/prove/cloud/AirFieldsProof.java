package nephele.workshop.prove.cloud;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirFiles;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.ClearSky;
import nephele.engine.atmosphere.LightFieldFile;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Computes the light of clear air and compares it with the program's file; computes that of other air and keeps it. */
public final class AirFieldsProof implements Proof {
    private static final double MOST_QUICK_DIFFERENCE = 0.005;
    /** Logarithm of light at late dusk, 10⁻⁹ of the sun's: darker nodes are too dark for the eye. */
    private static final double DARKEST = -20;

    private static final double MOST_DIFFERENCE = 1e-4;

    /** Other air: thin, hazy with a narrow forward peak, over snow and without ozone. */
    private static final List<Air> OTHERS = List.of(
            new Air(Vec3.ZERO, 0.5, 0.7, 1, 0),
            new Air(new Vec3(0.3, 0.3, 0.3), 8, 0.9, 1, 0.005),
            new Air(new Vec3(0.9, 0.9, 0.9), 1, 0.8, 0, 0.005));

    @Override
    public Claim claim() {
        return new Claim(
                "air-fields",
                "The light field of clear air that the program carries is the one that it computes: no number differs"
                    + " by more than 0.0001, nor, where it is not dark, by more than 0.005 if it is computed as"
                    + " quickly as that of other air. That of other air is computed once and then found, to the last"
                    + " bit; the progress of the computation grows from 0 to 1.",
                "airs",
                1 + OTHERS.size(),
                1);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws IOException {
        ProofResult result = ProofResult.NOTHING;
        for (long unit = from; unit < from + count; unit++) {
            result = result.and(unit == 0 ? clear() : other(OTHERS.get((int) unit - 1)));
            progress.unitsDone(unit - from + 1);
        }
        return result;
    }

    private static ProofResult clear() throws IOException {
        ByteArrayOutputStream computed = new ByteArrayOutputStream();
        LightFieldFile.write(computed);
        double difference = LightFieldFile.differenceFromClear(new ByteArrayInputStream(computed.toByteArray()));
        List<String> failures = new ArrayList<>();
        if (!(difference <= MOST_DIFFERENCE)) {
            Path file = Path.of("build", "clear-air.field");
            Files.createDirectories(file.getParent());
            Files.write(file, computed.toByteArray());
            failures.add("unit 0: numbers of clear-air.field differ by " + difference
                    + "; if the model of the air changed, replace the resource by " + file);
        }
        ByteArrayOutputStream quick = new ByteArrayOutputStream();
        LightFieldFile.writeQuick(quick);
        double quickDifference =
                LightFieldFile.differenceFromClear(new ByteArrayInputStream(quick.toByteArray()), DARKEST);
        if (!(quickDifference <= MOST_QUICK_DIFFERENCE)) {
            failures.add("unit 0: numbers of clear air that are computed quickly differ by " + quickDifference);
        }
        return ProofResult.of(
                1,
                failures,
                Figure.greatest("numbers of clear air off", difference, ""),
                Figure.greatest("computed quickly", quickDifference, ""));
    }

    private static ProofResult other(Air air) {
        Map<String, byte[]> kept = new HashMap<>();
        AirFiles files = AirFiles.in(kept);
        List<Double> progress = Collections.synchronizedList(new ArrayList<>());
        Vec3 computed = colour(AirTables.of(air, files, progress::add));
        List<Double> grown = progress.stream().sorted().toList();
        List<String> failures = new ArrayList<>();
        if (!grown.equals(progress) || grown.get(0) != 0 || grown.get(grown.size() - 1) != 1) {
            failures.add(air + ": progress " + progress);
        }
        Vec3 found = colour(AirTables.of(air, files, done -> failures.add(air + ": computed twice")));
        if (!found.equals(computed)) {
            failures.add(air + ": " + computed + " was computed, " + found + " found");
        }
        return ProofResult.of(1, failures, Figure.sum("fields kept", kept.size(), ""));
    }

    private static Vec3 colour(AirTables tables) {
        return new ClearSky(tables).radiance(0, new Vec3(0.6, 0.8, 0), new Vec3(0, 0.28, 0.96));
    }
}
