package nephele.app.play.hud;

/** The size of the picture in points. */
public record Area(double width, double height) {
    double centreX() {
        return width / 2;
    }

    double centreY() {
        return height / 2;
    }
}
