package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.Picture;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.billboard.AlphaCoverage;
import nephele.engine.level.billboard.FacingAxes;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.level.billboard.Sprite;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * An image of a billboard with edges, without sway. Crossed ones stand still, as drawn; so do all before an observer. The others face each ray's own
 * origin at infinity instead of the eye, which behind portals no ray knows: seen at an angle θ off their middle, they are
 * smaller by θ² / 2 of that distance than drawn ones. Shadow rays meet them turned to the light, as in the sun's map.
 */
final class BillboardShape implements TracedShape {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 SIDE = new Vec3(1, 0, 0);

    private final PlantedBillboards.Group group;
    private final int number;
    private final int index;
    private final Picture picture;
    private final ColourDecoding decoding;
    private final double turn;
    private final Vec3 observer;
    private final Vec3 middle;
    private final double halfWidth;
    private final double halfHeight;

    /**
     * @param number of the group in the level
     * @param index of the billboard in its group
     * @param quarterTurns of a crossed one's image: 0 or 1
     * @param observer the place that it faces; {@code null} for the origin of each ray
     */
    private BillboardShape(
            PlantedBillboards.Group group,
            int number,
            int index,
            int quarterTurns,
            Picture picture,
            ColourDecoding decoding,
            Vec3 observer) {
        this.group = group;
        this.number = number;
        this.index = index;
        this.picture = picture;
        this.decoding = decoding;
        turn = group.turn(index) + quarterTurns * StrictMath.PI / 2;
        Billboards.Size size = group.authored().sizeMetres();
        halfWidth = size.width() * group.scale(index) / 2;
        halfHeight = size.height() * group.scale(index) / 2;
        this.observer = observer;
        middle = group.feet().get(index).plus(new Vec3(0, halfHeight, 0));
    }

    /** Returns the images of all billboards with edges, in the order of the level; blended ones are not traced, as particles. */
    static List<BillboardShape> of(PlacedLevel placed, ColourDecoding decoding, double seconds) {
        List<BillboardShape> shapes = new ArrayList<>();
        Vec3 observer = placed.level().observerStart();
        PlantedBillboards planted = PlantedBillboards.of(placed.level(), placed.statics(), placed.assets());
        for (int number = 0; number < planted.groups().size(); number++) {
            PlantedBillboards.Group group = planted.groups().get(number);
            if (group.authored().blended()) {
                continue;
            }
            Sprite sprite = Sprite.of(group.authored(), placed.assets());
            int images = group.authored().facing() == Facing.CROSSED ? 2 : 1;
            for (int i = 0; i < images * group.feet().size(); i++) {
                int index = i / images;
                Picture picture = sprite.frames().get(frame(group, index, seconds));
                shapes.add(new BillboardShape(group, number, index, i % images, picture, decoding, observer));
            }
        }
        return shapes;
    }

    /** Returns the frame that is drawn at a time. */
    private static int frame(PlantedBillboards.Group group, int index, double seconds) {
        int frames = group.authored().frames();
        double moved = seconds * group.authored().framesPerSecond();
        return (int) Math.floorMod((long) Math.floor(moved + group.phase(index) * frames), (long) frames);
    }

    /** Returns the number of its group in the level. */
    int number() {
        return number;
    }

    /** A place on the image; right and up are −1 to 1. */
    private record Spot(double parameter, double right, double up, FacingAxes axes) {}

    /** Returns the place where a ray meets the image's opaque part; {@code null} if it does not. */
    private Spot spot(Ray ray) {
        Vec3 direction = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        Facing facing = group.authored().facing() == Facing.SCREEN
                ? Facing.SPHERICAL
                : group.authored().facing();
        Vec3 towards = observer == null ? direction.negated() : observer.minus(middle);
        FacingAxes axes = FacingAxes.of(facing, towards, SIDE, UP, turn);
        Vec3 front = axes.front();
        Vec3 toMiddle = middle.minus(new Vec3(ray.originX(), ray.originY(), ray.originZ()));
        double parameter = toMiddle.dot(front) / direction.dot(front);
        Vec3 at = direction.scaled(parameter).minus(toMiddle);
        double right = at.dot(axes.right()) / halfWidth;
        double up = at.dot(axes.up()) / halfHeight;
        boolean isMet = Math.abs(right) <= 1 && Math.abs(up) <= 1 && sample(right, up, 3) >= 255 * AlphaCoverage.TEST;
        return isMet ? new Spot(parameter, right, up, axes) : null;
    }

    /** Returns a channel between the four nearest pixels, 0 to 255. */
    private double sample(double right, double up, int channel) {
        double x = (0.5 + 0.5 * right) * picture.width() - 0.5;
        double y = (0.5 - 0.5 * up) * picture.height() - 0.5;
        int column = (int) Math.floor(x);
        int row = (int) Math.floor(y);
        double upper = between(code(column, row, channel), code(column + 1, row, channel), x - column);
        double lower = between(code(column, row + 1, channel), code(column + 1, row + 1, channel), x - column);
        return between(upper, lower, y - row);
    }

    private static double between(double a, double b, double fraction) {
        return a + (b - a) * fraction;
    }

    /** Returns a stored value; of colours the linear one, on the same scale. */
    private double code(int column, int row, int channel) {
        int x = Math.min(Math.max(column, 0), picture.width() - 1);
        int y = Math.min(Math.max(row, 0), picture.height() - 1);
        int code = picture.sample(x, y, channel);
        return channel == 3 ? code : 255 * decoding.linear(code / 255.0);
    }

    @Override
    public Aabb bounds() {
        return group.bounds(index);
    }

    @Override
    public double entry(Ray ray, double least, double most) {
        Spot spot = spot(ray);
        return spot != null && spot.parameter() >= least ? spot.parameter() : Double.POSITIVE_INFINITY;
    }

    @Override
    public boolean intersects(Ray ray, double limit) {
        Spot spot = spot(ray);
        return spot != null && spot.parameter() >= 0 && spot.parameter() <= limit;
    }

    @Override
    public boolean shadesItself() {
        return false;
    }

    @Override
    public EmissiveSurfaces.Emitter emitter(int item, SurfaceAppearance looks) {
        return null;
    }

    @Override
    public SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceAppearance looks) {
        Spot spot = spot(path.ray());
        Vec3 front = spot.axes().front();
        Vec3 towards = front.dot(Vec3.of(toEye)) < 0 ? front.negated() : front;
        Vector3d normal = towards.addScaled(
                        PlantedBillboards.BULGE * spot.right(), spot.axes().right())
                .addScaled(PlantedBillboards.BULGE * spot.up(), spot.axes().up())
                .toVector()
                .normalize();
        Vec3 colour = group.authored().colour() != null
                ? group.authored().colour()
                : new Vec3(
                        sample(spot.right(), spot.up(), 0) / 255,
                        sample(spot.right(), spot.up(), 1) / 255,
                        sample(spot.right(), spot.up(), 2) / 255);
        Vec3 emission = group.authored().emission().times(colour);
        return new SurfacePoint(
                path.item(), place, normal, normal, normal, colour.toVector(), null, toEye, emission, true);
    }
}
