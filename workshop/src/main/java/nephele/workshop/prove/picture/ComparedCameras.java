package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import nephele.host.terminal.CommandFailure;

/**
 * The assignment of levels and cameras to the units of a proof: a few cameras of every level, then the next few of
 * every level, so that an interrupted run has covered all levels evenly.
 *
 * @param files levels by path
 * @param atOnce successive cameras of a level; a divisor of {@link #OF_A_LEVEL}
 */
record ComparedCameras(List<String> files, int atOnce) {
    static final int OF_A_LEVEL = 50;

    ComparedCameras {
        files = List.copyOf(files);
        if (atOnce < 1 || OF_A_LEVEL % atOnce != 0) {
            throw new IllegalArgumentException(atOnce + " at once do not divide " + OF_A_LEVEL + " cameras");
        }
    }

    /** Cameras of one level, from {@code first} on. */
    record Visit(String file, int first, int count) {}

    /** @throws CommandFailure if there are no levels */
    long all() {
        requireLevels();
        return (long) OF_A_LEVEL * files.size();
    }

    /** Returns the units [{@code from}, {@code from + count}) in order. */
    List<Visit> visits(long from, long count) {
        requireLevels();
        var visits = new ArrayList<Visit>();
        for (long unit = from; unit < from + count; ) {
            long turn = unit / atOnce;
            int within = (int) (unit % atOnce);
            int cameras = (int) Math.min(from + count - unit, atOnce - within);
            int first = (int) (turn / files.size()) * atOnce + within;
            visits.add(new Visit(files.get((int) (turn % files.size())), first, cameras));
            unit += cameras;
        }
        return visits;
    }

    private void requireLevels() {
        if (files.isEmpty()) {
            throw CommandFailure.environment("the levels of a checkout are compared: run this in one");
        }
    }

    /** Returns a description of a picture with the options of {@code render} that draw it again. */
    static String again(String file, int camera, View view) {
        Vec3 e = view.eye();
        Vec3 b = view.back();
        double tan = Math.tan(view.projection().verticalFovRadians() / 2)
                * view.projection().aspect();
        return String.format(
                Locale.ROOT,
                "%s camera %d (--eye %s,%s,%s --target %s,%s,%s --fov %s)",
                file,
                camera,
                e.x(),
                e.y(),
                e.z(),
                e.x() - b.x(),
                e.y() - b.y(),
                e.z() - b.z(),
                Math.toDegrees(2 * Math.atan(tan)));
    }
}
