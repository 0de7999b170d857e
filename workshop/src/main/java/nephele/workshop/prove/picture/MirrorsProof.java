package nephele.workshop.prove.picture;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Makes the comparisons of {@code portal-ids} and {@code portal-light} in a room of facing mirrors and portals. */
public final class MirrorsProof implements Proof {
    private static final List<String> ROOM = List.of("levels/samples/mirror.json");

    private static final int CAMERAS = 20;

    private final PortalIdsProof ids = new PortalIdsProof(ROOM);
    private final PortalLightProof light;

    /** Uses the folder {@code build/proofs/oracle} of the working directory. */
    public MirrorsProof() {
        this(320, 64, Path.of("build", "proofs", "oracle"));
    }

    /**
     * @param width of a lit picture of 16 by 9, in pixels
     * @param samples rays a pixel of it
     * @param folder for traced pictures
     */
    public MirrorsProof(int width, int samples, Path folder) {
        light = new PortalLightProof(ROOM, width, samples, folder);
    }

    @Override
    public Claim claim() {
        return new Claim(
                "mirrors",
                "Among facing mirrors, in portals seen in them and with portals in them, no pixel away from edges shows"
                        + " another surface than the exact twin; and: "
                        + light.claim().sentence(),
                "cameras",
                CAMERAS,
                1);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult lit = light.run(from, count, Progress.NONE);
        return ids.run(from, count, progress).and(new ProofResult(0, 0, lit.figures(), List.of()));
    }

    @Override
    public ProofResult judged(ProofResult soFar) {
        ProofResult lit = light.judged(soFar);
        var figures = new ArrayList<>(soFar.figures());
        figures.removeIf(figure -> figure.name().contains(ROOM.get(0)));
        figures.addAll(lit.figures());
        var examples = new ArrayList<>(soFar.examples());
        examples.addAll(lit.examples());
        return new ProofResult(soFar.units(), soFar.failures() + lit.failures(), figures, examples);
    }
}
