package sunbeam.precompute.method;

/**
 * A form in which a method stands beside others in comparisons.
 *
 * @param name the method's, with what distinguishes the form
 * @param method with the form's settings
 * @param note what it approximates, where that is not the power under the Gaussian window; empty otherwise
 */
public record Variant(String name, Method method, String note) {}
