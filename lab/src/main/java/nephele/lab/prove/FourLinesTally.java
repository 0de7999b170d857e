package nephele.lab.prove;

import java.util.List;

/** How often the four lines of the student report answer otherwise than the areas, for its rectangle where one aims. */
final class FourLinesTally {
    private int asked;
    private int accepted;
    private int wronglyAccepted;
    private int wronglyRefused;

    void judge(WallShot shot) {
        if (shot.wall.soup() == null) {
            return;
        }
        RectangleQuestion question = RectangleQuestion.of(shot);
        boolean accepts = question.byFourLines();
        asked++;
        accepted += accepts ? 1 : 0;
        wronglyAccepted += accepts && !question.fits() ? 1 : 0;
        wronglyRefused += question.fits() && !accepts ? 1 : 0;
    }

    List<Figure> figures() {
        return List.of(
                Figure.sum("rectangles shown to the four lines", asked, ""),
                Figure.sum("accepted by them", accepted, ""),
                Figure.sum("wrongly accepted", wronglyAccepted, ""),
                Figure.sum("wrongly refused", wronglyRefused, ""));
    }
}
