package nephele.workshop.prove.cloud;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.LongStream;
import nephele.engine.math.Hash64;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Compares random walks with the laws of light in clouds that have closed forms. */
public final class CloudLawsProof implements Proof {
    private static final int SEED = 4;

    private final List<CloudLaw> laws = CloudLaws.all();

    @Override
    public Claim claim() {
        return new Claim(
                "cloud-laws",
                "Random walks obey Beer's and Lambert's law, the Gaussian puff's optical depth, the closed forms of"
                    + " light scattered once, the white furnace, reciprocity, and Chandrasekhar's H function (albedo"
                    + " up to 0.99 on slabs of optical depth 200; albedo 1 on 1,000, within their transmittance):"
                    + " within 4 standard errors of at most 0.002.",
                "laws",
                laws.size(),
                40);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var done = new AtomicLong();
        return LongStream.range(from, from + count)
                .parallel()
                .mapToObj(law -> compared((int) law, 1, CloudLaw.MOST_ERROR))
                .peek(result -> progress.unitsDone(done.incrementAndGet()))
                .reduce(ProofResult.NOTHING, ProofResult::and);
    }

    int laws() {
        return laws.size();
    }

    /**
     * Compares one law, numbered from 0.
     *
     * @param share of the paths at full count
     */
    ProofResult compared(int number, double share, double mostError) {
        CloudLaw law = laws.get(number);
        return law.compared(Hash64.combine(SEED, number), (long) (share * law.paths()), mostError);
    }
}
