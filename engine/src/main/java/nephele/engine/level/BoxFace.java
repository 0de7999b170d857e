package nephele.engine.level;

import java.util.Arrays;
import nephele.engine.math.Vec3;

/** A side of a box, named by its outward normal. */
public enum BoxFace {
    PLUS_X("+x", new Vec3(1, 0, 0)),
    MINUS_X("-x", new Vec3(-1, 0, 0)),
    PLUS_Y("+y", new Vec3(0, 1, 0)),
    MINUS_Y("-y", new Vec3(0, -1, 0)),
    PLUS_Z("+z", new Vec3(0, 0, 1)),
    MINUS_Z("-z", new Vec3(0, 0, -1));

    private final String text;
    private final Vec3 normal;

    BoxFace(String text, Vec3 normal) {
        this.text = text;
        this.normal = normal;
    }

    /** Returns the side of a name, such as {@code +x}. */
    public static BoxFace of(String text) {
        return Arrays.stream(values())
                .filter(side -> side.text.equals(text))
                .findFirst()
                .orElseThrow();
    }

    /** Returns 1 for the same side, −1 for the opposite one, 0 for another. */
    public int dot(BoxFace other) {
        return (int) normal.dot(other.normal);
    }

    /** Returns the side's name in a level file, such as {@code +x}. */
    public String text() {
        return text;
    }

    public Vec3 normal() {
        return normal;
    }
}
