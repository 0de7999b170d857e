package nephele.host.playthrough;

import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.math.Vec3;

/** Walls with portals, 0.6 m one after another along the path, far apart in the level, and a wall behind the last. */
final class TightRow {
    static final double TO_DOOR = 0.6;

    private static final double APART = 20;
    private static final Vec3 AHEAD = new Vec3(0, 0, 1);
    private static final Vec3 BACK = new Vec3(0, 0, -1);

    private TightRow() {}

    static Level level(int doors, double wallMetres) {
        var room = new RoomLevel();
        for (int door = 0; door < doors; door++) {
            double x = APART * door;
            room.box(x - 3, 0, TO_DOOR, x + 3, 4, TO_DOOR + 0.3);
            room.box(x + APART - 3, 0, -0.3, x + APART + 3, 4, 0);
            room.pair(new Vec3(x, 1.5, TO_DOOR), BACK, new Vec3(x + APART, 1.5, 0), AHEAD);
        }
        double x = APART * doors;
        return room.box(x - 3, 0, wallMetres, x + 3, 4, wallMetres + 0.3).level();
    }
}
