package nephele.app.play.hud;

/** A rectangle of the picture in points, from the upper left corner. */
record Box(double left, double top, double right, double bottom) {
    static Box of(Area area) {
        return new Box(0, 0, area.width(), area.height());
    }

    double width() {
        return right - left;
    }

    double height() {
        return bottom - top;
    }

    /** Returns the part of this box right of a line. */
    Box rightOf(double x) {
        return new Box(Math.max(left, x), top, right, bottom);
    }

    /** Returns the part of this box above a line. */
    Box above(double y) {
        return new Box(left, top, right, Math.min(bottom, y));
    }

    /** Returns the part of this box below a line. */
    Box below(double y) {
        return new Box(left, Math.max(top, y), right, bottom);
    }

    /** Returns true if both boxes have points inside in common. */
    boolean overlaps(Box other) {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }

    /** Returns the left edge of something of this width that is at this centre, or as near to it as this box allows. */
    double leftOf(double width, double centre) {
        return Math.rint(Math.max(left, Math.min(centre - width / 2, right - width)));
    }
}
