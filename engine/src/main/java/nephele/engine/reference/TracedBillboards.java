package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.Picture;
import nephele.engine.level.Billboards;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.level.billboard.Sprite;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;

/**
 * The billboards that rays intersect: those with edges. Blended ones are not traced, as particles are not.
 *
 * @param shapes in the order of the level
 * @param groups for each shape, the place of its record in the level
 */
record TracedBillboards(List<TracedShape> shapes, List<Integer> groups) {
    static final TracedBillboards NONE = new TracedBillboards(List.of(), List.of());

    static TracedBillboards of(PlacedLevel placed, ColourDecoding decoding, double seconds) {
        List<TracedShape> shapes = new ArrayList<>();
        List<Integer> groups = new ArrayList<>();
        Vec3 observer = placed.level().observerStart();
        PlantedBillboards planted = PlantedBillboards.of(placed.level(), placed.statics(), placed.assets());
        for (int number = 0; number < planted.groups().size(); number++) {
            PlantedBillboards.Group group = planted.groups().get(number);
            if (group.authored().blended()) {
                continue;
            }
            Sprite sprite = Sprite.of(group.authored(), placed.assets());
            int images = group.authored().facing() == Billboards.Facing.CROSSED ? 2 : 1;
            for (int i = 0; i < images * group.feet().size(); i++) {
                int index = i / images;
                Picture picture = sprite.frames().get(frame(group, index, seconds));
                shapes.add(new BillboardShape(group, index, i % images, picture, decoding, observer));
                groups.add(number);
            }
        }
        return new TracedBillboards(shapes, groups);
    }

    /** Returns the frame that is drawn at a time. */
    private static int frame(PlantedBillboards.Group group, int index, double seconds) {
        int frames = group.authored().frames();
        double moved = seconds * group.authored().framesPerSecond();
        return (int) Math.floorMod((long) Math.floor(moved + group.phase(index) * frames), (long) frames);
    }
}
