package nephele.lab.trade;

/**
 * The circumstances under which a report was made, in words.
 *
 * @param picture size, rays of the reference picture, camera
 */
public record Circumstances(
        String level, String levelFile, String picture, String machine, String graphics, String commit, String date) {}
