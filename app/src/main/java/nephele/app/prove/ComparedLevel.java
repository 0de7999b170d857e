package nephele.app.prove;

import java.util.List;
import java.util.Locale;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;

/** Which level and camera a unit of a proof is: all cameras of a level follow one another. */
record ComparedLevel(String file, int camera) {
    static final int CAMERAS = 50;

    static ComparedLevel of(List<String> files, long unit) {
        return new ComparedLevel(files.get((int) (unit / CAMERAS)), (int) (unit % CAMERAS));
    }

    /** The picture in words, and the options that draw it again. */
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
