package nephele.workshop.prove.portals;

import java.util.List;
import nephele.engine.render.frame.PortalTechnique;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Moves eyes through a portal in steps of 0.1 mm and looks for a frame that shows a wall that must not be visible. */
public final class EyeCrossingsProof implements Proof {
    @Override
    public Claim claim() {
        return new Claim(
                "eye-crossings",
                "No frame of an eye that passes through a portal in steps of 0.1 mm shows the wall of the"
                        + " portal or an empty pixel.",
                "crossings",
                10_000,
                1_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        long frames = 0;
        long bad = 0;
        long crossed = 0;
        for (PortalTechnique technique : PortalTechnique.values()) {
            try (EyeCrossings crossings = new EyeCrossings(technique)) {
                for (long i = technique.ordinal(); i < count; i += PortalTechnique.values().length) {
                    crossings.cross(from + i);
                    progress.unitsDone((i + technique.ordinal() * count) / 2);
                }
                frames += crossings.frames();
                bad += crossings.badFrames();
                crossed += crossings.crossed();
            }
        }
        return new ProofResult(
                count,
                bad + (count - crossed),
                List.of(
                        Figure.sum("frames", frames, ""),
                        Figure.sum("frames that show a wall or nothing", bad, ""),
                        Figure.sum("eyes that came through", crossed, "")),
                List.of());
    }
}
