package jrtr.glsl;

/** Blanks out comments line by line; remembers a block comment that is still open. GLSL has no string literals. */
final class CommentStripper {
    private boolean insideBlock;

    /** The line with each comment replaced by a blank. */
    String strip(String line) {
        StringBuilder code = new StringBuilder(line.length());
        int position = 0;
        while (position < line.length()) {
            if (insideBlock) {
                int end = line.indexOf("*/", position);
                if (end < 0) {
                    break;
                }
                insideBlock = false;
                code.append(' ');
                position = end + 2;
            } else if (line.startsWith("//", position)) {
                break;
            } else if (line.startsWith("/*", position)) {
                insideBlock = true;
                position += 2;
            } else {
                code.append(line.charAt(position));
                position++;
            }
        }
        return code.toString().stripTrailing();
    }

    /** Whether a block comment has begun and not ended. */
    boolean isInsideBlock() {
        return insideBlock;
    }
}
