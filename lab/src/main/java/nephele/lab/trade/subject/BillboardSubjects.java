package nephele.lab.trade.subject;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.Level;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** How billboards are turned and filtered, judged in their sample. */
public final class BillboardSubjects {
    private static final String LEVEL = "levels/samples/billboards.json";
    private static final String ORACLE = "the oracle: rays through the level, many a pixel";

    private static final Trade.Text FACING_TEXT = new Trade.Text(
            "Turning of billboards",
            "Those of the sample that are upright and turned to the eye, turned in other ways or crossed, which takes"
                    + " twice the pictures. The formula of the source faces away from eyes at smaller z, so it errs"
                    + " nothing in this view. Which way is nearest to a tree is what treeKind says.",
            ORACLE + ", each of which meets the sample's own billboards, turned to it");

    public static final Trade FACING = PictureSubjects.of(
                    "spriteFacing",
                    FACING_TEXT,
                    List.of(),
                    "cylindrical",
                    Stream.of(Facing.CYLINDRICAL, Facing.SPHERICAL, Facing.SCREEN, Facing.CROSSED, Facing.SOURCE)
                            .map(BillboardSubjects::turned)
                            .toList())
            .in(LEVEL, "spriteFacing", FACING_TEXT);

    public static final Trade COVERAGE = PictureSubjects.setting(
                    "spriteCoverage", ORACLE, PictureSetting.all("spriteCoverage", "kept", "mean"))
            .in(LEVEL);

    private BillboardSubjects() {}

    private static PictureSetting turned(Facing facing) {
        return new PictureSetting(
                Setting.of(facing.name().toLowerCase(Locale.ROOT)), shot -> shot.with(turned(shot.level(), facing)));
    }

    private static Level turned(Level level, Facing facing) {
        return level.withBillboards(level.billboards().stream()
                .map(group -> group.facing() == Facing.CYLINDRICAL ? group.turned(facing) : group)
                .toList());
    }
}
