package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The lit width of a face of 1 m by 1 m with the normal +x, with a wall 30 cm in front of its right half. */
class LitPartTest {
    @ParameterizedTest
    @CsvSource({
        "0.25, 0.4, false, straight on; half the face is lit",
        "0.25, 0.51, true, straight on; wider than what is lit",
        "0.75, 0.51, false, in the shade nothing is narrow",
        "0.01, 0.4, false, at the edge the way across is as long",
    })
    void narrowIsTheShortestWayAcross(double z, double metres, boolean isNarrower, String why) {
        var boxes = new WhiteBoxes();
        boxes.box(-0.5, 0.5, 0.5, 1, 1, 1);
        boxes.box(0.35, 0.5, 1, 0.1, 4, 1);
        var part = LitPart.at(boxes.brushes(), new Vec3(0, 0.5, z), new Vec3(1, 0, 0), 100);
        assertEquals(isNarrower, part.isNarrowerThan(metres), why);
    }

    @ParameterizedTest
    @CsvSource({"0.05, true", "0.5, false"})
    void aGrazedFaceIsNarrow(double sine, boolean isNarrower) {
        var boxes = new WhiteBoxes();
        boxes.box(-0.5, 0.5, 0.1, 1, 1, 0.2);
        Vec3 way = Directions.unit(sine, 0, Math.sqrt(1 - sine * sine));
        var part = LitPart.at(boxes.brushes(), new Vec3(0, 0.5, 0.1), way, 100);
        assertEquals(isNarrower, part.isNarrowerThan(0.02));
    }
}
