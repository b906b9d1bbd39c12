/** Acceptance tests: the real program, started by the real launcher, as a user starts it. */
package sunbeam.acceptance;
