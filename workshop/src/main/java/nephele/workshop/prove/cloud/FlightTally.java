package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.measure.LinearPicture;

/** The errors of the frames of a flight, and of its steps from frame to frame: those of the reference are taken off. */
final class FlightTally {
    /** FLIP by which a step may be greater than that of the reference. */
    private static final double MOST_STEP = 0.02;

    private final String name;
    private final List<String> failures = new ArrayList<>();
    private LinearPicture referenceBefore;
    private LinearPicture seenBefore;
    private int frames;
    private double sum;
    private double worst;
    private double beyond = Double.NEGATIVE_INFINITY;

    /** @param name of the flight, for messages */
    FlightTally(String name) {
        this.name = name;
    }

    /** Adds the next frame. */
    void add(LinearPicture reference, LinearPicture seen) {
        double error = CloudFlight.flip(reference, seen);
        sum += error;
        worst = Math.max(worst, error);
        if (frames > 0) {
            double step = CloudFlight.flip(seenBefore, seen) - CloudFlight.flip(referenceBefore, reference);
            beyond = Math.max(beyond, step);
            if (!(step <= MOST_STEP)) {
                failures.add(String.format(Locale.ROOT, "%s, frame %d: step %.4f beyond", name, frames, step));
            }
        }
        referenceBefore = reference;
        seenBefore = seen;
        frames++;
    }

    LinearPicture lastSeen() {
        return seenBefore;
    }

    double mean() {
        return sum / frames;
    }

    double worst() {
        return worst;
    }

    /** Returns by how much the greatest step is above that of the reference. */
    double beyond() {
        return beyond;
    }

    /** Returns the steps that are too great, in words. */
    List<String> failures() {
        return failures;
    }
}
