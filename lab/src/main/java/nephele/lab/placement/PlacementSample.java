package nephele.lab.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.MovingSurfaces;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.ShotRay;

/**
 * Rectangles shot at walls of triangles with holes, from the placement proof. Each is prepared for both tests of
 * whether it fits at the aimed place, with the true answer from clipped areas. No columns are on these walls, because
 * the four lines consider only triangles.
 */
public final class PlacementSample {
    private final List<Question> questions = new ArrayList<>();

    private record Question(RectangleQuestion rectangle, Placement fixed) {}

    public PlacementSample(int count) {
        for (long seed = 0; questions.size() < count; seed++) {
            var random = new SplittableRandom(seed);
            WallShot shot = new WallShot(RandomWall.of(random), random);
            if (shot.wall.soup() != null && shot.wall.columns().isEmpty()) {
                questions.add(question(shot));
            }
        }
    }

    private static Question question(WallShot shot) {
        RectangleQuestion asked = RectangleQuestion.of(shot);
        Gun fixed = new Gun(asked.rectangle(), shot.gun.rangeMetres(), 0);
        return new Question(asked, new Placement(shot.wall.surfaces(), fixed));
    }

    public int size() {
        return questions.size();
    }

    /** Returns the true answer: true if the rectangle fits at the aimed place. */
    public boolean fits(int question) {
        return questions.get(question).rectangle.fits();
    }

    public boolean fourLines(int question) {
        return questions.get(question).rectangle.byFourLines();
    }

    /** Returns the exact search's answer for the aimed place only. */
    public boolean exact(int question) {
        Question asked = questions.get(question);
        ShotRay aim = asked.rectangle.shot().aim;
        return asked.fixed.place("shot", aim, List.of(), MovingSurfaces.NONE) instanceof PlacementResult.Fits;
    }
}
